#pragma once

#include <Eigen/Core>

#include "base/require.h"

namespace twrench::body {

/// Throws OutOfRange about "moments" unless they are positive and finite, and InvalidArgument
/// unless they are ascending.
inline void require_ascending_moments(const Eigen::Vector3d& moments) {
  require_positive_entries("moments", moments);
  if (moments[0] <= moments[1] && moments[1] <= moments[2]) return;
  throw InvalidArgument("moments", "must be ascending");
}

}  // namespace twrench::body
