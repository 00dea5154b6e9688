#include "check/verdict/inertia.h"

#include <twrench/body/mass_properties.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// The symmetric matrix with these entries: xx, yy, zz, xy, xz, yz.
Matrix3d symmetric(const Vector6d& entries) {
  Matrix3d matrix = entries.head<3>().asDiagonal();
  matrix(0, 1) = matrix(1, 0) = entries[3];
  matrix(0, 2) = matrix(2, 0) = entries[4];
  matrix(1, 2) = matrix(2, 1) = entries[5];
  return matrix;
}

/// The rate of change of I w - L0 in body axes for each entry of I: w x (I w).
Eigen::Matrix<double, 3, 6> gyroscopic_terms(const Vector3d& omega) {
  Eigen::Matrix<double, 3, 6> terms;
  for (int k = 0; k < 6; ++k) terms.col(k) = omega.cross(symmetric(Vector6d::Unit(k)) * omega);
  return terms;
}

/// The matrix, or its negative, with eigenvalues that are positive and not too far apart.
Matrix3d made_positive(Matrix3d matrix) {
  if (matrix.trace() < 0) matrix = -matrix;
  constexpr double least = 0.05;  // of the largest
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(matrix);
  const Vector3d& values = solver.eigenvalues();
  const Vector3d kept = values.cwiseMax(least * values.maxCoeff());
  return solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
}

/// The squares of I (w_b - w_a) - integral of (I w) x w, summed over pairs of rows that are about
/// half a radian apart, as a quadratic form of the entries of I.
Matrix6d sum_of_squares(std::span<const Row> rows) {
  double turned = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    turned += rows[i].omega.norm() * (rows[i].t - rows[i - 1].t);
  constexpr double apart = 0.5;  // rad
  const double turn = turned / static_cast<double>(rows.size() - 1);
  const auto stride = static_cast<std::size_t>(std::clamp(
      apart / turn, 1.0, static_cast<double>(std::max<std::size_t>(1, rows.size() / 4))));
  Matrix6d squares = Matrix6d::Zero();
  for (std::size_t first = 0; first + stride < rows.size();
       first += std::max<std::size_t>(1, stride / 4)) {
    Eigen::Matrix<double, 3, 6> equations;
    for (int k = 0; k < 6; ++k) {
      equations.col(k) =
          symmetric(Vector6d::Unit(k)) * (rows[first + stride].omega - rows[first].omega);
    }
    for (std::size_t i = first; i < first + stride; ++i) {
      const double interval = rows[i + 1].t - rows[i].t;
      equations +=
          interval / 2 * (gyroscopic_terms(rows[i].omega) + gyroscopic_terms(rows[i + 1].omega));
    }
    squares += equations.transpose() * equations;
  }
  return squares;
}

}  // namespace

Matrix3d changed_inertia(const Matrix3d& inertia, const InertiaChange& change) {
  Vector6d entries;
  entries << change[0], change[1], -change[0] - change[1], change[2], change[3], change[4];
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(symmetric(entries));
  constexpr double most = 10;  // keeps the moments finite
  const Vector3d growth = solver.eigenvalues().cwiseMax(-most).cwiseMin(most).array().exp();
  const Matrix3d root = inertia.llt().matrixL();
  const Matrix3d grown =
      solver.eigenvectors() * growth.asDiagonal() * solver.eigenvectors().transpose();
  const Matrix3d changed = root * grown * root.transpose();
  return (changed + changed.transpose()) / 2;
}

FittedInertia fitted_inertia(const Matrix3d& inertia,
                             const Eigen::Matrix<double, 5, 5>& covariance) {
  const body::PrincipalAxes principal = body::principal_axes(inertia);
  const auto ratios_at = [&](const InertiaChange& change) {
    const Vector3d moments = body::principal_axes(changed_inertia(inertia, change)).moments;
    return Vector3d(moments / moments[0]);
  };
  constexpr double step = 1e-5;
  Eigen::Matrix<double, 3, 5> derivative;
  for (int k = 0; k < 5; ++k) {
    const InertiaChange change = step * InertiaChange::Unit(k);
    derivative.col(k) = (ratios_at(change) - ratios_at(-change)) / (2 * step);
  }
  const Matrix3d of_ratios = derivative * covariance * derivative.transpose();
  return {inertia / principal.moments[0], principal.moments / principal.moments[0],
          of_ratios.diagonal().cwiseSqrt(), principal.axes};
}

EstimatedInertia estimated_inertia(std::span<const Row> rows) {
  const Matrix6d squares = sum_of_squares(rows);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> diagonal(Matrix3d(squares.topLeftCorner<3, 3>()));
  const Eigen::SelfAdjointEigenSolver<Matrix6d> symmetrical(squares);
  return {made_positive(diagonal.eigenvectors().col(0).asDiagonal()),
          made_positive(symmetric(symmetrical.eigenvectors().col(0)))};
}

}  // namespace twrench::check
