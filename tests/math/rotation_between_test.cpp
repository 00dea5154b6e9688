#include "math/rotation_between.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace twrench::so3 {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double last_digits = 1e-15;

/// Expects a rotation that turns `from` to `to` about an axis perpendicular to both.
void expect_smallest_turn(const Vector3d& from, const Vector3d& to, double tolerance) {
  const Quaterniond turn = rotation_between(from, to);
  EXPECT_NEAR(turn.norm(), 1, last_digits);
  EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), tolerance);
  EXPECT_NEAR(turn.vec().dot(from.normalized()), 0, tolerance);
  EXPECT_NEAR(turn.vec().dot(to.normalized()), 0, tolerance);
  EXPECT_GE(turn.w(), 0);
}

TEST(RotationBetween, IsTheSmallestOne) {
  std::mt19937 random(2020);
  std::normal_distribution<double> number;
  for (int i = 0; i < 100; ++i) {
    const Vector3d from(number(random), number(random), number(random));
    const Vector3d to(number(random), number(random), number(random));
    // Lengths do not matter.
    expect_smallest_turn(1e-100 * from, 1e100 * to, 2e-15);
  }
}

TEST(RotationBetween, OfEqualDirectionsIsTheIdentity) {
  EXPECT_EQ(rotation_between({0, 0, 2}, {0, 0, 3}).coeffs(), Quaterniond::Identity().coeffs());
}

TEST(RotationBetween, OfOppositeDirectionsIsAHalfTurn) {
  for (const Vector3d& from : {Vector3d(1, 0, 0), Vector3d(0, -2, 0), Vector3d(0.3, -0.2, 5)}) {
    expect_smallest_turn(from, -from, last_digits);
    EXPECT_EQ(rotation_between(from, -from).w(), 0);
  }
}

TEST(RotationBetween, OfNearlyOppositeDirectionsIsARotation) {
  for (const double apart : {1e-3, 1e-5, 1e-7, 1e-9}) {
    const double angle = std::numbers::pi - apart;
    expect_smallest_turn({1, 0, 0}, {std::cos(angle), std::sin(angle), 0}, 2e-15);
  }
}

}  // namespace
}  // namespace twrench::so3
