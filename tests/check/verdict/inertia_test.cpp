#include "check/verdict/inertia.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/body/mass_properties.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
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

// A gyroscope often reads zero before a toss.
TEST(Inertia, IsNotFittedToRowsThatBeginAtRest) {
  std::vector<Row> rows = rows_of_body(inertia, Vector3d(0.3, 2, 0.4), 200);
  rows[0].omega.setZero();
  EXPECT_THAT(refusal(rows), testing::StartsWith("run.csv: its first row is at rest"));
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) rows[i].omega.setZero();
  EXPECT_THAT(refusal(rows), testing::StartsWith("run.csv: its first row is at rest"));
}

TEST(Inertia, StaysPositiveDefinite) {
  Matrix3d changed = inertia;
  for (int i = 0; i < 10; ++i) changed = changed_inertia(changed, {8, 3, -5, 2, 7});
  const Vector3d moments = body::principal_axes(changed).moments;
  EXPECT_GT(moments[0], 0);
  EXPECT_LT(moments[2], 1.01 * most_ratio_of_moments * moments[0]);
}

/// The rates of a phone that a hand turns, tosses and catches, with noise; its axes are turned
/// about z by an angle.
std::vector<Row> toss(double angle) {
  const Matrix3d axes = so3::exp(Vector3d(0, 0, angle));
  const motion::ExactMotion flight({Vector3d(225.6, 52.5, 276.8).asDiagonal(), {7, 0.3, 0.2}});
  std::vector<Row> rows(520);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = static_cast<double>(i) / 200, hand = std::clamp(t / 0.8, 0.0, 1.0);
    rows[i].t = t;
    rows[i].omega = hand * flight.at(std::clamp(t - 0.8, 0.0, 1.2)).omega;
  }
  add_noise(rows, 0.02, 1);
  for (Row& row : rows) row.omega = axes * row.omega;
  return rows;
}

TEST(Inertia, IsNotFittedToTinyTurns) {
  std::vector<Row> slow = toss(0), brief = slow;
  for (Row& row : slow) row.omega *= 1e-12;
  for (Row& row : brief) row.t *= 1e-6;
  const std::string message = "run.csv: its motion does not determine the ratios of the moments";
  EXPECT_THAT(refusal(slow), testing::StartsWith(message));
  EXPECT_THAT(refusal(brief), testing::StartsWith(message));
}

// A toss about the middle axis does not determine axes that are not those of the rows.
TEST(Inertia, OfTiltedBodyIsRightOrRefused) {
  const Vector3d ratios(1, 225.6 / 52.5, 276.8 / 52.5);
  for (const double degrees : {0, 1, 2, 5, 10, 20, 30, 45}) {
    const std::vector<Row> rows = toss(degrees * std::numbers::pi / 180);
    try {
      const FittedInertia found = fit_inertia("run.csv", std::span(rows).subspan(160, 240));
      const Vector3d error = (found.moments - ratios).cwiseAbs();
      EXPECT_TRUE((error.array() <= 3 * found.deviation.array()).all())
          << degrees << ": " << found.moments.transpose() << " +- " << found.deviation.transpose();
    } catch (const CheckError& error) {
      EXPECT_EQ(error.reason(), CheckError::Reason::no_inertia);
      EXPECT_GE(degrees, 1);
    }
  }
}

TEST(Inertia, OfNoisyTiltedBodyIsWithinThreeStandardErrors) {
  const Matrix3d axes = so3::exp(Vector3d(0.3, -0.2, 0.5));
  const Matrix3d body = axes * Vector3d(2, 3, 4.5).asDiagonal() * axes.transpose();
  const std::vector<Row> exact = rows_of_body(body, axes * Vector3d(2, 3, 2), 200);
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::vector<Row> rows = exact;
    add_noise(rows, 0.05, seed);
    const FittedInertia found = fit_inertia("run.csv", rows);
    const Vector3d error = (found.moments - Vector3d(1, 1.5, 2.25)).cwiseAbs();
    EXPECT_TRUE((error.array() <= 3 * found.deviation.array()).all()) << seed;
    EXPECT_LT(found.deviation.maxCoeff(), 0.1);
  }
}

// More rows in the same time do not take more work, nor do they make the ratios more precise.
TEST(Inertia, UsesABoundedNumberOfRows) {
  const motion::ExactMotion exact({inertia, Vector3d(0.3, 2, 0.4)});
  const auto deviation = [&](std::size_t count) {
    std::vector<Row> rows =
        rows_of([&](double t) { return exact.at(t); }, count, 40 / static_cast<double>(count));
    add_noise(rows, 0.01, 1);
    return fit_inertia("run.csv", rows).deviation.norm();
  };
  const double of_few = deviation(2048);
  EXPECT_NEAR(deviation(32768), of_few, 0.1 * of_few);
}

}  // namespace
}  // namespace twrench::check
