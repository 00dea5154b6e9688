#include "check/verdict/frame.h"

#include <Eigen/Eigenvalues>

namespace twrench::check {

using Eigen::Matrix3d;

Matrix3d nearest_rotation(const Matrix3d& X) {
  return X * Eigen::SelfAdjointEigenSolver<Matrix3d>(X.transpose() * X).operatorInverseSqrt();
}

}  // namespace twrench::check
