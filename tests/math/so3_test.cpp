#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace twrench::so3 {
namespace {

using std::numbers::pi;

// An entry of exp sums three terms of order one, and an entry of X^T X three more. That is nine
// roundings of 1.1e-16 each, and most of them cancel.
constexpr double round_off = 2e-15;

Vector3d random_direction(std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  Vector3d v;
  do {
    v = Vector3d(normal(generator), normal(generator), normal(generator));
  } while (v.norm() < 0.1);
  return v.normalized();
}

TEST(So3, HatIsTheCrossProduct) {
  const Vector3d w(1, 2, 3), v(-4, 5, 0.5);
  EXPECT_EQ(hat(w) * v, w.cross(v));
  EXPECT_EQ(vee(hat(w)), w);
}

class So3AtAngle : public testing::TestWithParam<double> {};

// Task 1a: X^T X = Id, at small angles and beyond a full turn.
TEST_P(So3AtAngle, ExpIsARotation) {
  std::mt19937_64 generator(1);
  for (int i = 0; i < 200; ++i) {
    const Matrix3d X = exp(GetParam() * random_direction(generator));
    EXPECT_LE((X.transpose() * X - Matrix3d::Identity()).cwiseAbs().maxCoeff(), round_off);
    EXPECT_NEAR(X.determinant(), 1.0, round_off);
  }
}

TEST_P(So3AtAngle, ExpAgreesWithTheQuaternion) {
  std::mt19937_64 generator(2);
  for (int i = 0; i < 200; ++i) {
    const Vector3d axis = random_direction(generator);
    const Matrix3d expected =
        Eigen::Quaterniond(Eigen::AngleAxisd(GetParam(), axis)).toRotationMatrix();
    // The length of the axis is 1 to 1e-16. An angle of 20 amplifies this error.
    EXPECT_LE((exp(GetParam() * axis) - expected).cwiseAbs().maxCoeff(),
              round_off * std::max(1.0, GetParam()));
  }
}

TEST_P(So3AtAngle, ExpTakesAStepAndAMatrix) {
  const double h = 0.25;
  const Vector3d omega = GetParam() / h * Vector3d(0.36, -0.48, 0.8);
  EXPECT_EQ(exp(h, hat(omega)), exp(h * omega));
}

TEST_P(So3AtAngle, LogUndoesExp) {
  std::mt19937_64 generator(3);
  for (int i = 0; i < 200; ++i) {
    const Vector3d u = GetParam() * random_direction(generator);
    const Vector3d w = log(exp(u));
    EXPECT_LE(w.norm(), pi * (1 + 1e-15));
    EXPECT_LE((exp(w) - exp(u)).norm(), 4 * round_off);
    if (GetParam() < pi) {
      EXPECT_LE((w - u).norm(), 4 * round_off * std::max(1.0, u.norm()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, So3AtAngle,
                         testing::Values(0.0, 1e-12, 1e-8, 1e-4, 1.0, 2.5, pi - 1e-9, pi, 20.0));

TEST(So3, SmallAnglesKeepTheirRelativeDigits) {
  // Computing 1 - cos directly would lose the second-order part of exp below 1e-8.
  for (const double angle : {1e-3, 1e-5, 1e-7}) {
    const Matrix3d X = exp(Vector3d(angle, angle, 0));
    EXPECT_NEAR(X(0, 1) / (0.5 * angle * angle), 1.0 - angle * angle / 6, 1e-9);
  }
}

TEST(So3, LogAtHalfATurnHasADefiniteSign) {
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1),
                               Vector3d(0.6, -0.8, 0), Vector3d(0, 0.6, -0.8)}) {
    const Matrix3d half_turn = 2 * axis * axis.transpose() - Matrix3d::Identity();
    EXPECT_LE((log(half_turn) - pi * axis).norm(), 1e-15) << axis.transpose();
  }
}

TEST(So3, GroupLaws) {
  std::mt19937_64 generator(4);
  for (int i = 0; i < 100; ++i) {
    const Vector3d axis = random_direction(generator);
    EXPECT_LE((exp(0.3 * axis) * exp(0.9 * axis) - exp(1.2 * axis)).norm(), round_off);
    EXPECT_LE((exp(axis) * exp(-axis) - Matrix3d::Identity()).norm(), round_off);
    const Matrix3d R = exp(random_direction(generator));
    EXPECT_LE((R * exp(axis) * R.transpose() - exp(R * axis)).norm(), 4 * round_off);
  }
}

}  // namespace
}  // namespace twrench::so3
