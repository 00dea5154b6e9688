#include "check/verdict/inertia.h"

#include <twrench/body/mass_properties.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Equations = Eigen::Matrix<double, 3, 6>;

/// The symmetric matrix with these entries: xx, yy, zz, xy, xz, yz.
Matrix3d symmetric(const Vector6d& entries) {
  Matrix3d matrix = entries.head<3>().asDiagonal();
  matrix(0, 1) = matrix(1, 0) = entries[3];
  matrix(0, 2) = matrix(2, 0) = entries[4];
  matrix(1, 2) = matrix(2, 1) = entries[5];
  return matrix;
}

/// The symmetric matrices of length 1 that add up to an inertia matrix.
Matrix3d unit_matrix(int k) { return symmetric(Vector6d::Unit(k)).normalized(); }

Matrix3d sum_of(const Vector6d& parts) {
  Matrix3d sum = Matrix3d::Zero();
  for (int k = 0; k < 6; ++k) sum += parts[k] * unit_matrix(k);
  return sum;
}

/// I w for each unit matrix.
Equations momentum_terms(const Vector3d& omega) {
  Equations terms;
  for (int k = 0; k < 6; ++k) terms.col(k) = unit_matrix(k) * omega;
  return terms;
}

/// w x (I w) for each unit matrix.
Equations gyroscopic_terms(const Vector3d& omega) {
  Equations terms = momentum_terms(omega);
  for (int k = 0; k < 6; ++k) terms.col(k) = omega.cross(Vector3d(terms.col(k)));
  return terms;
}

/// The matrix with eigenvalues of at least so many times the largest.
Matrix3d with_least(double least, const Matrix3d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(matrix);
  const Vector3d& values = solver.eigenvalues();
  if (values[0] >= least * values[2]) return matrix;
  const Vector3d kept = values.cwiseMax(least * values[2]);
  return solver.eigenvectors() * kept.asDiagonal() * solver.eigenvectors().transpose();
}

/// The squares of the changes of I w + the integral of w x (I w), summed over parts in which the
/// body turns by several radians, as a quadratic form of the entries of I. In a free motion, the
/// sum is constant. The longer the parts, the less the noise of the rates matters, and the more the
/// errors of the integral.
Matrix6d sum_of_squares(std::span<const Row> rows) {
  constexpr double most_turned = 8;  // rad
  Matrix6d squares = Matrix6d::Zero();
  for (std::size_t i = 0; i < rows.size();) {
    Equations integral = Equations::Zero(), sum = Equations::Zero();
    double count = 0, turned = 0;
    for (; i < rows.size() && turned < most_turned; ++i) {
      if (count > 0) {
        const double interval = rows[i].t - rows[i - 1].t;
        turned += interval * rows[i].omega.norm();
        integral +=
            interval / 2 * (gyroscopic_terms(rows[i - 1].omega) + gyroscopic_terms(rows[i].omega));
      }
      const Equations equations = momentum_terms(rows[i].omega) + integral;
      squares += equations.transpose() * equations;
      sum += equations;
      ++count;
    }
    squares -= sum.transpose() * sum / count;
  }
  return squares;
}

/// The entries with the least sum of squares among those with a given trace, up to their size.
template <int n>
Eigen::Vector<double, n> least_with_trace(const Eigen::Matrix<double, n, n>& squares) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, n, n>> solver(squares);
  constexpr double round_off = 1e-14;
  const double least =
      std::max(round_off * solver.eigenvalues()[n - 1], std::numeric_limits<double>::min());
  Eigen::Vector<double, n> trace = Eigen::Vector<double, n>::Zero();
  trace.template head<3>().setOnes();
  const Eigen::Vector<double, n> parts = (solver.eigenvectors().transpose() * trace)
                                             .cwiseQuotient(solver.eigenvalues().cwiseMax(least));
  return solver.eigenvectors() * parts.stableNormalized();
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
  return with_least(1 / most_ratio_of_moments, (changed + changed.transpose()) / 2);
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
  const Vector3d moments = least_with_trace<3>(squares.topLeftCorner<3, 3>());
  constexpr double least = 0.05;
  return {with_least(least, moments.asDiagonal()),
          with_least(least, sum_of(least_with_trace<6>(squares)))};
}

}  // namespace twrench::check
