#pragma once

#include <Eigen/Core>
#include <cmath>

// Functions that several shapes share.

namespace twrench::body::shapes {

inline Eigen::Vector3d at_height(double z) { return {0.0, 0.0, z}; }

inline double distance_from_axis(const Eigen::Vector3d& point) {
  return std::hypot(point.x(), point.y());
}

/// Returns a point at `radius` from the z axis, on the side of `direction`; on the x axis if
/// `direction` is along z.
inline Eigen::Vector3d beside_axis(double radius, const Eigen::Vector3d& direction) {
  const double length = distance_from_axis(direction);
  if (length == 0.0) return {radius, 0.0, 0.0};
  return {radius * direction.x() / length, radius * direction.y() / length, 0.0};
}

/// Returns the inertia matrix of a solid that is symmetric in its coordinate planes, from the mean
/// squares `s` of the coordinates about the centroid. The moment about an axis is the mass times
/// the sum of the mean squares of the other two coordinates.
inline Eigen::Matrix3d inertia_of(double mass, const Eigen::Vector3d& s) {
  const Eigen::Vector3d moments =
      mass * Eigen::Vector3d{s.y() + s.z(), s.x() + s.z(), s.x() + s.y()};
  return moments.asDiagonal();
}

}  // namespace twrench::body::shapes
