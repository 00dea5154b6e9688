#include "check/verdict/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twrench::check {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Replaces J = Q R and b by R, in the upper triangle of J, and Q^T b, with Householder's
/// reflections.
void triangulate(MatrixXd& J, VectorXd& b) {
  VectorXd v;
  for (Index k = 0; k < J.cols(); ++k) {
    const Index rows = J.rows() - k;
    v = J.col(k).tail(rows);
    const double norm = v.norm();
    if (norm == 0) continue;
    const double diagonal = v[0] > 0 ? -norm : norm;
    v[0] -= diagonal;
    v /= v.norm();
    for (Index j = k + 1; j < J.cols(); ++j) {
      const double twice = 2 * v.dot(J.col(j).tail(rows));
      J.col(j).tail(rows) -= twice * v;
    }
    const double twice = 2 * v.dot(b.tail(rows));
    b.tail(rows) -= twice * v;
    J(k, k) = diagonal;
  }
}

/// Solves R x = b, for the upper triangle R of a matrix.
VectorXd back_substituted(const MatrixXd& R, const VectorXd& b) {
  VectorXd x(R.cols());
  for (Index i = R.cols() - 1; i >= 0; --i) {
    double sum = b[i];
    for (Index j = i + 1; j < R.cols(); ++j) sum -= R(i, j) * x[j];
    x[i] = sum / R(i, i);
  }
  return x;
}

/// The residuals near a point as linear functions of a step: R step + b, and others that are
/// constant.
struct Linearized {
  MatrixXd R;
  VectorXd b;

  /// The step that minimizes the sum of squares plus the squared length of the scaled step times
  /// `damping`.
  VectorXd step(const VectorXd& scale, double damping) const {
    const Index n = R.cols();
    MatrixXd rows = MatrixXd::Zero(2 * n, n);
    VectorXd right = VectorXd::Zero(2 * n);
    for (Index i = 0; i < n; ++i) {
      for (Index j = i; j < n; ++j) rows(i, j) = R(i, j);
      rows(n + i, i) = std::sqrt(damping) * scale[i];
      right[i] = -b[i];
    }
    triangulate(rows, right);
    return back_substituted(rows, right);
  }

  /// The decrease of the sum of squares that a step promises.
  double decrease(const VectorXd& step) const {
    double sum = 0;
    for (Index i = 0; i < R.cols(); ++i) {
      double change = 0;
      for (Index j = i; j < R.cols(); ++j) change += R(i, j) * step[j];
      sum -= change * (change + 2 * b[i]);
    }
    return sum;
  }
};

}  // namespace

VectorXd minimized(const LeastSquares& problem) {
  constexpr double round_off = std::numeric_limits<double>::epsilon();
  constexpr int most_steps = 200;
  const Index n = problem.parameters;
  VectorXd p = VectorXd::Zero(n), scale = VectorXd::Zero(n);
  VectorXd residuals(problem.residuals), moved(problem.residuals);
  MatrixXd jacobian(problem.residuals, n);
  problem.evaluate(p, residuals);
  double sum = residuals.squaredNorm(), damping = 1e-6, growth = 2;
  Linearized linearized;
  bool is_current = false;
  for (int count = 0; count < most_steps; ++count) {
    if (!is_current) {
      problem.differentiate(p, jacobian);
      for (Index i = 0; i < n; ++i) scale[i] = std::max(scale[i], jacobian.col(i).norm());
      for (double& size : scale) {
        if (size == 0) size = 1;
      }
      VectorXd b = residuals;
      triangulate(jacobian, b);
      linearized = {jacobian.topRows(n), b.head(n)};
      is_current = true;
    }
    const VectorXd step = linearized.step(scale, damping);
    const VectorXd next = p + step;
    problem.evaluate(next, moved);
    const double left = moved.squaredNorm(), actual = sum - left;
    const double promised = linearized.decrease(step);
    const bool is_better = actual > 0;
    const bool is_small =
        step.cwiseProduct(scale).norm() <= round_off * p.cwiseProduct(scale).norm();
    if (is_better) {
      const double gain = std::clamp(actual / promised, 0.0, 1.0);
      p = next;
      residuals = moved;
      sum = left;
      damping *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
      growth = 2;
      is_current = false;
    } else {
      damping *= growth;
      growth *= 2;
    }
    // The sum does not show what so small a step gains.
    if (promised <= round_off * sum && std::isfinite(left)) return next;
    if (is_small || !(promised > 0)) break;
  }
  return p;
}

MatrixXd inverse_of_squares(MatrixXd J) {
  const Index n = J.cols();
  VectorXd none = VectorXd::Zero(J.rows());
  triangulate(J, none);
  MatrixXd inverse_R(n, n);
  for (Index i = 0; i < n; ++i) inverse_R.col(i) = back_substituted(J, VectorXd::Unit(n, i));
  MatrixXd result(n, n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) result(i, j) = inverse_R.row(i).dot(inverse_R.row(j));
  }
  return result;
}

}  // namespace twrench::check
