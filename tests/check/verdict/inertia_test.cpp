#include "check/verdict/inertia.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "check/recordings.h"
#include "check/verdict/error.h"
#include "check/verdict/fit.h"
#include "sanitizers.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<Row> rows_of_body(const Matrix3d& body, const Vector3d& start, std::size_t count) {
  const motion::ExactMotion exact({body, start});
  return rows_of([&](double t) { return exact.at(t); }, count, 0.02);
}

void add_noise(std::vector<Row>& rows, double deviation, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, deviation);
  for (Row& row : rows) row.omega += Vector3d(normal(random), normal(random), normal(random));
}

std::string refusal(const std::vector<Row>& rows) {
  try {
    fit_inertia("run.csv", rows);
  } catch (const CheckError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Inertia, ChangesWithoutItsSize) {
  const Matrix3d changed = changed_inertia(inertia, InertiaChange(0.3, -0.2, 0.1, 0.5, -0.4));
  EXPECT_NEAR(changed.determinant(), inertia.determinant(), 1e-12);
  EXPECT_TRUE(changed_inertia(inertia, InertiaChange::Zero()).isApprox(inertia, 1e-15));
}

// The principal axes of some of these bodies are not the axes of the file.
TEST(Inertia, IsFoundToTheDigitsOfTheRates) {
  const Matrix3d axes = so3::exp(Vector3d(0.3, -0.2, 0.5));
  for (const Vector3d& of_body : {Vector3d(2, 3, 4.5), Vector3d(1, 1.2, 1.9), Vector3d(2, 2, 3)}) {
    const Matrix3d body = axes * of_body.asDiagonal() * axes.transpose();
    std::vector<Row> rows = rows_of_body(body, axes * Vector3d(0.3, 2, 0.4), 400);
    for (Row& row : rows) row.omega = (row.omega * 1e9).array().round() / 1e9;
    const FittedInertia found = fit_inertia("run.csv", rows);
    EXPECT_LT((found.moments - of_body / of_body[0]).norm(), 1e-7) << of_body.transpose();
    EXPECT_LT((found.inertia - body / of_body[0]).norm(), 1e-7);
    EXPECT_LT(found.deviation.norm(), 1e-7);
  }
}

// Both ratios are right within three standard errors in 95 of 100 noisy recordings.
TEST(Inertia, IsWithinThreeStandardErrors) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  const Vector3d ratios(1, 1.5, 2.25);
  const std::vector<Row> exact =
      rows_of_body(Vector3d(2, 3, 4.5).asDiagonal(), Vector3d(0.3, 8, 0.4), 60);
  int right = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::vector<Row> rows = exact;
    add_noise(rows, 0.05, seed);
    const FittedInertia found = fit_inertia("run.csv", rows);
    const Vector3d error = (found.moments - ratios).cwiseAbs();
    right += (error.array() <= 3 * found.deviation.array()).all() ? 1 : 0;
    EXPECT_LT(found.deviation.maxCoeff(), 0.1);
  }
  EXPECT_GE(right, 95);
}

TEST(Inertia, IsNotDeterminedByEveryMotion) {
  const std::string message = "does not determine the ratios of the moments";
  const std::vector<Row> steady = rows_of_body(inertia, Vector3d(0, 0, 2), 200);
  EXPECT_THAT(refusal(steady), testing::HasSubstr(message));
  std::vector<Row> noisy = steady;
  add_noise(noisy, 0.01, 1);
  EXPECT_THAT(refusal(noisy), testing::HasSubstr(message));
  std::vector<Row> of_ball = rows_of_body(Matrix3d::Identity(), Vector3d(1, 2, 3), 200);
  EXPECT_THAT(refusal(of_ball), testing::HasSubstr(message));
  add_noise(of_ball, 1e-6, 1);
  EXPECT_THAT(refusal(of_ball), testing::HasSubstr(message));
  EXPECT_THAT(refusal({steady.begin(), steady.begin() + 5}), testing::HasSubstr(message));
  EXPECT_THAT(refusal(rows_of_body(inertia, Vector3d::Zero(), 200)), testing::HasSubstr(message));
}

}  // namespace
}  // namespace twrench::check
