#pragma once

#include <Eigen/Core>

namespace twrench::body {

/// Returns the inertia about the origin of a point mass at d, the second term of the parallel-axis
/// theorem.
inline Eigen::Matrix3d point_inertia(double mass, const Eigen::Vector3d& d) {
  return mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
}

}  // namespace twrench::body
