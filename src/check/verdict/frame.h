#pragma once

#include <Eigen/Core>

namespace twrench::check {

/// Returns the rotation nearest to X, which is a rotation up to errors.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& X);

}  // namespace twrench::check
