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

/// Linearizes the problem at p, whose residuals are given. `scale` becomes the largest length of
/// each column of the derivatives so far; a parameter without influence has the scale 1.
Linearized linearized_at(const VectorXd& p, VectorXd residuals, const LeastSquares& problem,
                         VectorXd& scale) {
  MatrixXd jacobian(problem.residuals, problem.parameters);
  problem.differentiate(p, jacobian);
  for (Index i = 0; i < problem.parameters; ++i) {
    scale[i] = std::max(scale[i], jacobian.col(i).norm());
    if (scale[i] == 0) scale[i] = 1;
  }
  triangulate(jacobian, residuals);
  return {jacobian.topRows(problem.parameters), residuals.head(problem.parameters)};
}

}  // namespace

VectorXd minimized(const LeastSquares& problem) {
  constexpr double round_off = std::numeric_limits<double>::epsilon();
  constexpr int most_steps = 200;
  VectorXd p = VectorXd::Zero(problem.parameters), scale = p;
  VectorXd residuals(problem.residuals), moved(problem.residuals);
  problem.evaluate(p, residuals);
  Linearized linearized = linearized_at(p, residuals, problem, scale);
  double sum = residuals.squaredNorm(), damping = 1e-6, growth = 2;
  for (int count = 0; count < most_steps; ++count) {
    const VectorXd step = linearized.step(scale, damping);
    const VectorXd next = p + step;
    problem.evaluate(next, moved);
    const double left = moved.squaredNorm(), actual = sum - left;
    const double promised = linearized.decrease(step);
    // The sum does not show what so small a step gains.
    if (promised <= round_off * sum && std::isfinite(left)) return next;
    const bool is_last = !(promised > 0) || step.cwiseProduct(scale).norm() <=
                                                round_off * p.cwiseProduct(scale).norm();
    if (actual > 0) {
      const double gain = std::clamp(actual / promised, 0.0, 1.0);
      p = next;
      residuals = moved;
      sum = left;
      damping *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
      growth = 2;
      if (!is_last) linearized = linearized_at(p, residuals, problem, scale);
    } else {
      damping *= growth;
      growth *= 2;
    }
    if (is_last) break;
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
