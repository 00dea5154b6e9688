// Task 2: with I = Id, X(0) = Id and L = e_x, the solution is exactly X(t) = exp(t hat(e_x)).
#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/stepper.h>
#include <twrench/motion/trajectory.h>

#include <cmath>

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const FreeBody sphere(Matrix3d::Identity(), Vector3d::UnitX());

double error_at_end(const Method& method, int steps) {
  const double t = 10.0;
  StepControl control;
  control.step = t / steps;
  const double times[] = {t};
  const Sample end = integrate(sphere, method, control, times).samples[0];
  return (end.X - so3::exp(t * Vector3d::UnitX())).norm();
}

// Tasks 3 and 4: omega of a sphere is constant, so every method on the group is exact.
TEST(Sphere, EveryLieMethodIsExact) {
  for (const Method& method : methods()) {
    if (method.linear()) continue;
    // Round-off of at most five products per step, which grows at most linearly.
    EXPECT_LE(error_at_end(method, 1000), 5e-13) << method.name;
    EXPECT_LE(error_at_end(method, 10), 1e-14) << method.name;
  }
}

TEST(Sphere, EulerIsFirstOrderAndLeavesTheGroup) {
  const Method& euler = find_method("euler");
  const double coarse = error_at_end(euler, 10'000), fine = error_at_end(euler, 20'000);
  EXPECT_NEAR(std::log2(coarse / fine), 1.0, 0.01);

  const double h = 0.1;
  const Matrix3d W = take_step(sphere, euler, Matrix3d::Identity(), h).X;
  EXPECT_EQ(W, Matrix3d::Identity() + h * so3::hat(Vector3d::UnitX()));  // eq. (24)
  EXPECT_NEAR(W.determinant(), 1 + h * h, 1e-15);
}

// Eq. (24) uses (W I)^-1. Off SO(3) the transpose would give a different omega.
TEST(Sphere, EulerTakesTheInverse) {
  const Matrix3d W = 2 * Matrix3d::Identity();
  EXPECT_EQ(angular_velocity(sphere, find_method("euler"), W), Vector3d(0.5, 0, 0));
  EXPECT_EQ(angular_velocity(sphere, find_method("lie-euler"), W), Vector3d(2, 0, 0));
}

}  // namespace
}  // namespace twrench::motion
