#pragma once

#include <Eigen/Core>
#include <functional>

namespace twrench::check {

/// A nonlinear problem of least squares: the residuals, and their derivatives with respect to the
/// parameters, a matrix with a row for each residual and a column for each parameter.
struct LeastSquares {
  Eigen::Index parameters, residuals;
  std::function<void(const Eigen::VectorXd& p, Eigen::VectorXd& residuals)> evaluate;
  std::function<void(const Eigen::VectorXd& p, Eigen::MatrixXd& jacobian)> differentiate;
};

/// Returns the parameters with the least sum of squares near zero, to round-off: the method of
/// Levenberg and Marquardt with the scaling of More, "The Levenberg-Marquardt Algorithm:
/// Implementation and Theory", 1978, and the damping of Nielsen, "Damping Parameter in Marquardt's
/// Method", 1999. Eigen has this method too, but its templates take long to compile.
Eigen::VectorXd minimized(const LeastSquares& problem);

/// Returns the inverse of J^T J. If its columns are dependent, numbers of it are not finite.
Eigen::MatrixXd inverse_of_squares(Eigen::MatrixXd J);

}  // namespace twrench::check
