#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>

#include "motion/reference.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Matrix3d body_inertia = Vector3d(2, 3, 5).asDiagonal();

// Task 1b.
TEST(Energy, IsHalfOmegaDotIOmega) {
  EXPECT_DOUBLE_EQ(energy(body_inertia, {1, 2, -1}), 0.5 * (2 + 12 + 5));
  Matrix3d full = body_inertia;
  full(0, 1) = full(1, 0) = 0.5;
  EXPECT_DOUBLE_EQ(energy(full, {1, 2, -1}), 0.5 * (2 + 12 + 5 + 2));
}

TEST(Diagnostics, VanishOnTheExactMotion) {
  for (const ReferenceCase& c : reference_cases()) {
    const double start = energy(c.body.inertia(), c.omega0);
    for (const Sample& sample : c.samples) {
      const Diagnostics d = diagnose(c.body, start, sample);
      EXPECT_NEAR(d.energy_drift, 0, 4e-15) << c.name << " " << sample.t;
      EXPECT_NEAR(d.orthogonality_error, 0, 1e-15) << c.name << " " << sample.t;
      EXPECT_NEAR(d.momentum_error, 0, 1e-14) << c.name << " " << sample.t;
    }
  }
}

TEST(Diagnostics, SeeEachFault) {
  const Vector3d omega(1, 2, -1);
  const FreeBody body(body_inertia, omega);
  const double start = energy(body_inertia, omega);
  EXPECT_NEAR(diagnose(body, start, {0, Matrix3d::Identity(), 1.1 * omega}).energy_drift, 0.21,
              1e-12);
  EXPECT_NEAR(diagnose(body, start, {0, 2 * Matrix3d::Identity(), omega}).orthogonality_error,
              3 * std::sqrt(3.0), 1e-12);
  const Matrix3d turned = so3::exp(Vector3d(0, 0, 0.1));
  EXPECT_GT(diagnose(body, start, {0, turned, omega}).momentum_error, 0.05);
}

TEST(Diagnostics, OfABodyAtRestAreZero) {
  const FreeBody body(body_inertia, Vector3d::Zero());
  const Diagnostics d = diagnose(body, 0, {0, Matrix3d::Identity(), Vector3d::Zero()});
  EXPECT_EQ(d.energy_drift, 0);
  EXPECT_EQ(d.momentum_error, 0);
}

}  // namespace
}  // namespace twrench::motion
