#pragma once

namespace twrench::body {

/// Returns whether two principal moments, the smaller one first, count as equal when the behaviour
/// of a body is described. The moments of a symmetric mesh differ by what its facets and the
/// rounding of its coordinates leave. A body with two equal moments has an axis of symmetry, and no
/// intermediate axis.
inline bool are_equal_moments(double smaller, double greater) {
  return greater - smaller <= 1e-4 * greater;
}

}  // namespace twrench::body
