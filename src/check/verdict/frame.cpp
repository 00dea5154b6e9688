#include "check/verdict/frame.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace twrench::check {

using Eigen::Matrix3d;

Matrix3d nearest_rotation(const Matrix3d& X) {
  return X * Eigen::SelfAdjointEigenSolver<Matrix3d>(X.transpose() * X).operatorInverseSqrt();
}

Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

}  // namespace twrench::check
