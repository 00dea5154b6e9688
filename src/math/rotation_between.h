#pragma once

#include <Eigen/Geometry>

namespace twrench::so3 {

/// Returns the smallest rotation that turns the direction of `from` into that of `to`; neither is
/// zero. Between opposite directions it is a half turn about an axis perpendicular to both.
/// Eigen's FromTwoVectors computes that axis by a singular value decomposition, which takes long to
/// compile.
Eigen::Quaterniond rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace twrench::so3
