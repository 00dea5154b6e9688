#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace twrench::check {

/// A row in the program's units and conventions.
struct Row {
  std::size_t number = 0;  ///< among the rows of data, from 1
  double t = 0;            ///< s since the first row
  /// rad/s, body axes; zero if the file has no rates.
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();
  /// space_from_body. Quaternions are normalised, matrices are not. The identity if the file has no
  /// attitude.
  Eigen::Matrix3d X = Eigen::Matrix3d::Identity();
  /// How far the file's numbers are from a rotation: Frobenius norm of X^T X - Id for a matrix,
  /// | |q|^2 - 1 | for a quaternion, 0 for Euler angles.
  double orthogonality_error = 0;
};

}  // namespace twrench::check
