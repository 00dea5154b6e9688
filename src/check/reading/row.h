#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace twrench::check {

/// A row in the program's units and conventions.
struct Row {
  std::size_t number = 0;  ///< of the rows of data, from 1
  double t = 0;            ///< s, as the file says it, its own offset kept
  /// rad/s, body axes; zero where the file has no rates.
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();
  /// space_from_body: of quaternions after normalisation, of matrices as they are; the identity
  /// where the file has no attitude.
  Eigen::Matrix3d X = Eigen::Matrix3d::Identity();
  /// Of the file's own numbers: Frobenius norm of X^T X - Id, or | |q|^2 - 1 |; 0 of Euler angles.
  double orthogonality_error = 0;
};

}  // namespace twrench::check
