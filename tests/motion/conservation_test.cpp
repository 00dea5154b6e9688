// Measures what each method conserves and compares it with the method's description.
#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/stepper.h>

#include <cmath>

#include "motion/every_method.h"
#include "motion/reference.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class Conservation : public testing::TestWithParam<Method> {
 protected:
  const FreeBody body_{Vector3d(1, 2, 3).asDiagonal(), {0.3, 1.1, -0.4}};
};

INSTANTIATE_TEST_SUITE_P(All, Conservation, every_method(), method_test_name);

/// Returns the largest |energy drift| of `steps` steps of h.
double energy_drift(const FreeBody& body, const Method& method, double h, int steps) {
  const double start = 0.5 * body.momentum().dot(body.inverse() * body.momentum());
  Matrix3d X = Matrix3d::Identity();
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    X = take_step(body, method, X, h).X;
    const double now = energy(body.inertia(), angular_velocity(body, method, X));
    largest = std::max(largest, std::abs(now / start - 1));
  }
  return largest;
}

TEST_P(Conservation, EnergyToRoundOffWhereClaimedAndOnlyThere) {
  const double drift = energy_drift(body_, GetParam(), 0.2, 1000);
  if (GetParam().conserves_energy) {
    EXPECT_LE(drift, 3e-13);  // round-off of a thousand steps
  } else {
    EXPECT_GT(drift, 1e-9);
  }
}

TEST_P(Conservation, OrthogonalityAndMomentumUnlessLinear) {
  Matrix3d X = Matrix3d::Identity();
  for (int i = 0; i < 1000; ++i) X = take_step(body_, GetParam(), X, 0.2).X;
  const Sample end{200, X, angular_velocity(body_, GetParam(), X)};
  const Diagnostics d = diagnose(body_, 1, end);
  if (GetParam().linear()) {
    EXPECT_GT(d.orthogonality_error, 1);
  } else {
    EXPECT_LE(d.orthogonality_error, 1e-12);
    EXPECT_LE(d.momentum_error, 1e-12);
  }
}

TEST_P(Conservation, ReversibleWhereClaimedAndOnlyThere) {
  const double h = GetParam().order.value_or(0) > 4 ? 2 : 0.2;  // so that the error is visible
  const Matrix3d X = take_step(body_, GetParam(), Matrix3d::Identity(), h).X;
  const Matrix3d back = take_step(body_, GetParam(), X, -h).X;
  const double missed = (back - Matrix3d::Identity()).norm();
  if (GetParam().reversible) {
    EXPECT_LE(missed, 2e-15);
  } else {
    EXPECT_GT(missed, 1e-9);
  }
}

// A splitting's energy error oscillates but does not grow, because the map is Poisson. It is as
// large over ten thousand steps as over the first thousand.
TEST(Strang, EnergyErrorStaysBounded) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.3, 1.1, -0.4});
  const Method& strang = find_method("strang");
  EXPECT_LE(energy_drift(body, strang, 0.1, 10'000), 1.2 * energy_drift(body, strang, 0.1, 1000));
  const Method& rk4 = find_method("rk4");
  EXPECT_GT(energy_drift(body, rk4, 0.1, 10'000), 2 * energy_drift(body, rk4, 0.1, 1000));
}

// The inertia need not be diagonal in the body's axes. The motion must be the same in rotated axes.
TEST_P(Conservation, DoesNotDependOnTheBodysAxes) {
  const Matrix3d R = so3::exp(Vector3d(0.4, -0.9, 0.5));  // body_from_turned
  const Matrix3d inertia = R.transpose() * body_.inertia() * R;
  const Matrix3d symmetric = (inertia + inertia.transpose()) / 2;
  const FreeBody turned(symmetric, R.transpose() * Vector3d(0.3, 1.1, -0.4));
  Matrix3d X = Matrix3d::Identity(), Y = Matrix3d::Identity();
  for (int i = 0; i < 20; ++i) {
    X = take_step(body_, GetParam(), X, 0.1).X;
    Y = take_step(turned, GetParam(), Y, 0.1).X;
  }
  EXPECT_LE((Y - R.transpose() * X * R).norm(), 1e-13);
}

TEST(TooLongAStep, IsRefusedNotGarbage) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.3, 1.1, -0.4});
  for (const char* name : {"rkmk4", "implicit-trapezoid"}) {
    EXPECT_TRUE(std::isinf(take_step(body, find_method(name), Matrix3d::Identity(), 40).error))
        << name;
  }
}

}  // namespace
}  // namespace twrench::motion
