#include "check/verdict/least_squares.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace twrench::check {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The problem Misra1a of the Statistical Reference Datasets of the National Institute of Standards
/// and Technology, y = b1 (1 - exp(-b2 x)). The parameters are the relative changes of b1 and b2
/// from the second start that it gives.
struct Misra {
  static constexpr std::array x{77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
  static constexpr std::array y{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};
  static constexpr double b1 = 250, b2 = 0.0005;

  static LeastSquares problem(Eigen::Index parameters = 2) {
    return {parameters, x.size(),
            [](const VectorXd& p, VectorXd& residuals) {
              for (std::size_t i = 0; i < x.size(); ++i) {
                const double decay = std::exp(-b2 * (1 + p[1]) * x[i]);
                residuals[static_cast<Eigen::Index>(i)] = b1 * (1 + p[0]) * (1 - decay) - y[i];
              }
            },
            [](const VectorXd& p, MatrixXd& jacobian) {
              jacobian.setZero();
              for (std::size_t i = 0; i < x.size(); ++i) {
                const auto row = static_cast<Eigen::Index>(i);
                const double decay = std::exp(-b2 * (1 + p[1]) * x[i]);
                jacobian(row, 0) = b1 * (1 - decay);
                jacobian(row, 1) = b1 * (1 + p[0]) * decay * b2 * x[i];
              }
            }};
  }
};

TEST(LeastSquares, AreTheCertifiedOnes) {
  const LeastSquares problem = Misra::problem();
  const VectorXd p = minimized(problem);
  EXPECT_NEAR(Misra::b1 * (1 + p[0]), 2.3894212918e+02, 1e-8);
  EXPECT_NEAR(Misra::b2 * (1 + p[1]), 5.5015643181e-04, 1e-14);

  VectorXd residuals(problem.residuals);
  problem.evaluate(p, residuals);
  EXPECT_NEAR(residuals.squaredNorm(), 1.2455138894e-01, 1e-11);

  MatrixXd jacobian(problem.residuals, problem.parameters);
  problem.differentiate(p, jacobian);
  const MatrixXd covariance = residuals.squaredNorm() / 12 * inverse_of_squares(jacobian);
  EXPECT_NEAR(Misra::b1 * std::sqrt(covariance(0, 0)), 2.7070075241, 1e-9);
  EXPECT_NEAR(Misra::b2 * std::sqrt(covariance(1, 1)), 7.2668688436e-06, 1e-15);
  EXPECT_EQ(covariance(0, 1), covariance(1, 0));
}

TEST(LeastSquares, LeaveAParameterWithoutInfluence) {
  const VectorXd p = minimized(Misra::problem(3));
  EXPECT_NEAR(Misra::b1 * (1 + p[0]), 2.3894212918e+02, 1e-8);
  EXPECT_NEAR(p[2], 0, 1e-12);
}

/// Rosenbrock's valley, whose least value is zero at (1, 1).
TEST(LeastSquares, FollowACurvedValley) {
  const VectorXd p = minimized(
      {2, 2,
       [](const VectorXd& at, VectorXd& residuals) {
         residuals << 10 * (at[1] - at[0] * at[0]), 1 - at[0];
       },
       [](const VectorXd& at, MatrixXd& jacobian) { jacobian << -20 * at[0], 10, -1, 0; }});
  EXPECT_NEAR(p[0], 1, 1e-14);
  EXPECT_NEAR(p[1], 1, 1e-14);
}

}  // namespace
}  // namespace twrench::check
