#pragma once

#include <Eigen/Core>

namespace twrench::check {

/// Returns the rotation nearest to X, which is a rotation up to errors.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& X);

/// Returns the smallest rotation that turns the direction of `from` into that of `to`.
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace twrench::check
