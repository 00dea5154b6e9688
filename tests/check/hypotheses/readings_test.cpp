#include "check/hypotheses/readings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "check/hypotheses/changed_rows.h"
#include "check/recordings.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(Misfit, IsNearZeroOfWhatFollowsTheMotion) {
  const std::vector<Row> rows = exact_rows(128, 0.05);
  for (const bool rates : {true, false}) {
    const Misfit found = misfit(inertia, rows, rates, true);
    EXPECT_LT(*found.attitude, 1e-9);
    EXPECT_TRUE(found.fits());
  }
}

TEST(Misfit, IsLargeOfAnotherBody) {
  const std::vector<Row> rows = exact_rows(128, 0.05);
  const Matrix3d other = Vector3d(3, 2, 4).asDiagonal();
  EXPECT_FALSE(misfit(other, rows, true, false).fits());
  EXPECT_FALSE(misfit(other, rows, false, true).fits());
}

TEST(Misfit, SaysNothingOfASteadyMotion) {
  const motion::ExactMotion steady({inertia, Vector3d(0, 0, 1)});
  const auto rows = rows_of([&](double t) { return steady.at(t); }, 128, 0.05);
  EXPECT_FALSE(misfit(inertia, rows, true, false).rates);
  EXPECT_FALSE(misfit(inertia, rows, false, true).attitude);
}

// Rates that are constant although Euler's equations change them.
TEST(Misfit, IsLargeWhereWhatShouldChangeDoesNot) {
  std::vector<Row> rows = exact_rows(128, 0.05);
  for (Row& row : rows) row.omega = omega;
  const Misfit found = misfit(inertia, rows, true, false);
  EXPECT_FALSE(found.fits());
}

// The rates of a symmetric body are periodic. With half a period too many between rows, those two
// rows apart fit.
TEST(Misfit, IsLargeOfFarRowsThatFitByChance) {
  const Matrix3d symmetric = Vector3d(2, 2, 3).asDiagonal();
  const motion::ExactMotion exact({symmetric, omega});
  const double period = 2 * std::numbers::pi / (0.5 * std::abs(omega.z()));
  constexpr double step = 0.05;
  std::vector<Row> rows = rows_of([&](double t) { return exact.at(t); }, 128, step);
  for (Row& row : rows) row.t *= (step + 20.5 * period) / step;
  EXPECT_FALSE(misfit(symmetric, rows, true, false).fits());
}

// A first-order method with a step as long as in games still follows the motion.
TEST(Misfit, ForgivesACoarseMethod) {
  std::vector<Row> rows;
  Vector3d w = omega;
  constexpr double step = 1.0 / 60;
  for (std::size_t i = 0; i < 256; ++i) {
    rows.push_back({.number = i + 1, .t = static_cast<double>(i) * step, .omega = w});
    w += step * (inertia.inverse() * (inertia * w).cross(w));
  }
  EXPECT_TRUE(misfit(inertia, rows, true, false).fits());
}

TEST(Variation, IsTheLargerOneOfMomentumAndEnergy) {
  EXPECT_LT(variation(inertia, exact_rows(128, 0.05)), 1e-7);
  std::vector<Row> rows(2);
  rows[0].omega = {1, 0, 0};
  rows[1].omega = {2, 0, 0};
  // |L| is 1 and 2 times something, the energy 1 and 4 times.
  EXPECT_NEAR(variation(inertia, rows), 1.5 / 2.5, 1e-12);
  rows[1].omega = {0, inertia(0, 0) / inertia(1, 1), 0};
  const double ratio = inertia(0, 0) / inertia(1, 1);  // of the energies; |L| is the same
  EXPECT_NEAR(variation(inertia, rows), std::abs(1 - ratio) / (1 + ratio), 1e-12);
}

TEST(OnlyFitting, IsNoneWhereTwoFit) {
  const recording::Convention convention;
  const Reading good{convention, {0.01, {}}}, bad{convention, {0.9, {}}};
  EXPECT_TRUE(only_fitting({bad, good, bad}));
  EXPECT_FALSE(only_fitting({bad, good, good}));
  // Both could come from a coarse method, but one is far better.
  const Reading fair{convention, {0.1, {}}};
  EXPECT_TRUE(only_fitting({fair, good, bad}));
  EXPECT_FALSE(only_fitting({bad, bad}));
  EXPECT_FALSE(only_fitting({{convention, {}}}));
}

}  // namespace
}  // namespace twrench::check
