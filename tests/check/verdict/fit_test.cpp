#include "check/verdict/fit.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <atomic>
#include <random>

#include "check/recordings.h"
#include "check/verdict/error.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Exact rows with independent noise of the given standard deviations.
std::vector<Row> noisy(double of_rates, double of_attitude, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  std::vector<Row> rows = exact_rows(501, 0.4, 5);
  for (Row& row : rows) {
    row.omega += of_rates * vector();
    row.X *= so3::exp(of_attitude * vector());
  }
  return rows;
}

TEST(Fit, FindsTheStateAndHowWellItIsKnown) {
  const std::vector<Row> rows = noisy(1e-4, 0);
  const Fit found = fit("run.csv", inertia, rows, rows[0].omega, true, false);
  EXPECT_NEAR(*found.rate_residual, 1e-4, 3e-6);
  EXPECT_FALSE(found.attitude_residual);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(std::abs(found.reference.body.omega()[i] - omega[i]), 4 * found.omega_deviation[i]);
    EXPECT_LT(found.omega_deviation[i], 2e-5);
  }
  EXPECT_EQ(found.reference.start, 5);
}

// Over many files the errors match the covariance: in units of it, their mean square is the number
// of parameters.
TEST(Fit, TellsTheCovarianceThatErrorsHave) {
  double squares = 0;
  constexpr unsigned files = 20;
  for (unsigned seed = 0; seed < files; ++seed) {
    const std::vector<Row> rows = noisy(1e-4, 1e-3, seed);
    const Fit found = fit("run.csv", inertia, rows, rows[0].omega, true, true);
    const Vector3d error = found.reference.body.omega() - omega;
    squares += error.dot(found.omega_covariance.inverse() * error);
  }
  EXPECT_NEAR(squares / files, 3, 1.6);  // deviation sqrt(6/20) = 0.55
}

TEST(Fit, FindsItsWayFromAFarStart) {
  const std::vector<Row> rows = noisy(1e-6, 1e-6);
  const Fit found =
      fit("run.csv", inertia, rows, rows[0].omega + Vector3d(0.05, -0.05, 0.05), true, true);
  EXPECT_LT((found.reference.body.omega() - omega).norm(), 1e-6);
  EXPECT_NEAR(*found.attitude_residual, 1e-6, 1e-7);
  EXPECT_LT(found.frame_deviation->norm(), 1e-6);
}

TEST(Fit, TakesAttitudesAlone) {
  const std::vector<Row> rows = noisy(0, 1e-5);
  const Vector3d first = omega_between(inertia, rows[0], rows[1]);
  const Fit found = fit("run.csv", inertia, rows, first, false, true);
  EXPECT_LT((found.reference.body.omega() - omega).norm(), 3e-6);
}

TEST(Fit, NeedsTwoRowsAndABodyThatTurns) {
  const std::vector<Row> rows = exact_rows(1);
  EXPECT_THROW(fit("run.csv", inertia, rows, omega, true, true), CheckError);
  EXPECT_THROW(fit("run.csv", inertia, exact_rows(5), Vector3d::Zero(), true, true), CheckError);
}

TEST(Fit, EndsIfItIsStopped) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(fit("run.csv", inertia, exact_rows(), omega, true, true, &stop), CheckError);
}

TEST(OmegaBetween, IsExactOverLongSteps) {
  const std::vector<Row> rows = exact_rows(2, 0.5);
  EXPECT_LT((omega_between(inertia, rows[0], rows[1]) - omega).norm(), 1e-9);
}

}  // namespace
}  // namespace twrench::check
