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

/// Returns whether two principal moments, the smaller one first, count as equal when the behaviour
/// of a body is described. The moments of a symmetric mesh differ by what its facets and the
/// rounding of its coordinates leave. A body with two equal moments has an axis of symmetry, and no
/// intermediate axis.
inline bool are_equal_moments(double smaller, double greater) {
  return greater - smaller <= 1e-4 * greater;
}

}  // namespace twrench::body
