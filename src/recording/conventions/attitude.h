#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace twrench::recording {

/// The three axes (0, 1, 2 for x, y, z) of a sequence of Euler angles.
using Axes = std::array<int, 3>;

/// "zyx" -> 2, 1, 0.
Axes axes_of(const std::string& sequence);

/// Maps each axis of the sequence to the index of its angle in (yaw, pitch, roll). If the three
/// axes are different, yaw is about z, pitch about y and roll about x; otherwise they are the
/// first, second and third angle.
std::array<std::size_t, 3> angle_places(const Axes& axes);

/// Rotates by yaw, pitch and roll in rad about the axes of the sequence, each as turned by the
/// rotations before (intrinsic). Returns the matrix that takes components in the last frame to
/// those in the first.
Eigen::Matrix3d rotation_by_euler_angles(const Axes& axes, std::span<const double, 3> angles);

/// The rotation matrix of the quaternion w, x, y, z. Its length need not be 1, but must not be 0.
Eigen::Matrix3d rotation_by_quaternion(std::span<const double, 4> q);

/// The rotation matrix of the rotation vector, the axis times the angle in rad.
Eigen::Matrix3d rotation_by_vector(const Eigen::Vector3d& v);

/// The rotation matrix of modified Rodrigues parameters, the axis times tan(angle/4). Parameters
/// and their shadow, -s/|s|^2, have the same matrix.
Eigen::Matrix3d rotation_by_mrp(const Eigen::Vector3d& s);

/// The rotation matrix of (classical) Rodrigues parameters, the axis times tan(angle/2).
Eigen::Matrix3d rotation_by_rodrigues(const Eigen::Vector3d& g);

}  // namespace twrench::recording
