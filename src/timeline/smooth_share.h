#pragma once

#include <algorithm>

namespace twrench::timeline {

/// Rises from 0 to 1 while `share` does, with a smooth start and end.
inline double smooth_share(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

}  // namespace twrench::timeline
