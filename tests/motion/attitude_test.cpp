// Motions that do not start at the identity.
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/trajectory.h>

#include <array>
#include <vector>

#include "motion/bodies_of_every_kind.h"
#include "motion/every_method.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Matrix3d start_attitude = so3::exp(Vector3d(0.3, -1.2, 2.1));
constexpr std::array attitude_times{-3.0, 0.0, 0.5, 7.0, 40.0};

class AttitudeOfMethod : public testing::TestWithParam<Method> {};

TEST_P(AttitudeOfMethod, TurnsTheMotionWithTheAttitude) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02});
  const FreeBody turned(body.inertia(), body.omega(), start_attitude);
  EXPECT_LE((turned.momentum() - start_attitude * body.momentum()).norm(), 1e-15);
  const StepControl control{.step = 0.02, .tolerance = 1e-10};
  const auto own = integrate(body, GetParam(), control, attitude_times).samples;
  const auto other = integrate(turned, GetParam(), control, attitude_times).samples;
  for (std::size_t i = 0; i < attitude_times.size(); ++i) {
    EXPECT_LE((other[i].X - start_attitude * own[i].X).norm(), 1e-9) << attitude_times[i];
    EXPECT_LE((other[i].omega - own[i].omega).norm(), 1e-9) << attitude_times[i];
  }
  EXPECT_EQ(other[1].X, start_attitude);
  EXPECT_EQ(other[1].omega, body.omega());
}

INSTANTIATE_TEST_SUITE_P(All, AttitudeOfMethod, every_method(), method_test_name);

TEST(Attitude, TurnsTheExactMotionOfEveryBody) {
  for (const BodyOfAKind& b : bodies_of_every_kind()) {
    const FreeBody body(b.moments.asDiagonal(), b.omega);
    const ExactMotion own(body), turned(FreeBody(body.inertia(), body.omega(), start_attitude));
    for (const double t : attitude_times) {
      EXPECT_LE((turned.at(t).X - start_attitude * own.at(t).X).norm(), 1e-14);
      EXPECT_EQ(turned.at(t).omega, own.at(t).omega);
    }
  }
}

TEST(Attitude, IsThatOfTheFirstStep) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02}, start_attitude);
  for (const Method& method : methods()) {
    visit_steps(body, method, {}, 0.001, [&](const AcceptedStep& step) {
      if (step.t == 0) {
        EXPECT_LE((step.before - start_attitude).norm(), 1e-15) << method.name;
      }
    });
  }
}

TEST(Attitude, LeavesWhatIsConserved) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.3, 1, 0.02}, start_attitude);
  for (const Sample& sample : ExactMotion(body).at(attitude_times)) {
    const Diagnostics d = diagnose(body, energy(body.inertia(), body.omega()), sample);
    EXPECT_LT(std::abs(d.energy_drift), 1e-14);
    EXPECT_LT(d.momentum_error, 1e-14);
    EXPECT_LT(d.orthogonality_error, 1e-14);
  }
}

TEST(FreeBody, WithAnotherStartIsThatOfAnother) {
  for (const BodyOfAKind& b : bodies_of_every_kind()) {
    const Matrix3d inertia = start_attitude * b.moments.asDiagonal() * start_attitude.transpose();
    const Matrix3d symmetric = (inertia + inertia.transpose()) / 2;
    const Vector3d omega(0.1, -0.2, 0.3);
    const FreeBody body(symmetric, b.omega), other(symmetric, omega, start_attitude);
    const FreeBody start = body.with_start(omega, start_attitude);
    EXPECT_EQ(start.momentum(), other.momentum());
    EXPECT_EQ(start.inverse(), other.inverse());
    EXPECT_EQ(ExactMotion(start).at(3).X, ExactMotion(other).at(3).X);
    EXPECT_EQ(ExactMotion(body.with_omega(omega)).at(3).X,
              ExactMotion(FreeBody(symmetric, omega)).at(3).X);
    EXPECT_EQ(start.with_omega(b.omega).attitude(), start_attitude);
  }
}

TEST(ExactStep, GoesAlongTheMotion) {
  FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {1, 0.5, 0.2}, start_attitude);
  const ExactMotion motion(body);
  for (int i = 0; i < 1000; ++i) body = exact_step(body, 0.05);
  EXPECT_LE((body.attitude() - motion.at(50).X).norm(), 1e-11);
  EXPECT_LE((body.omega() - motion.at(50).omega).norm(), 1e-11);
  EXPECT_LE((exact_step(exact_step(body, 0.1), -0.1).attitude() - body.attitude()).norm(), 1e-14);
}

TEST(Sample, HasTheQuaternionOfItsAttitude) {
  for (const BodyOfAKind& b : bodies_of_every_kind()) {
    for (const Sample& sample :
         ExactMotion(FreeBody(b.moments.asDiagonal(), b.omega)).at(attitude_times)) {
      const Eigen::Quaterniond q(sample.quaternion());
      EXPECT_NEAR(q.norm(), 1, 1e-15);
      EXPECT_GE(q.w(), 0);
      EXPECT_LE((q.toRotationMatrix() - sample.X).norm(), 1e-14);
    }
  }
}

TEST(ExactMotion, LeavesOutTheArrayThatIsEmpty) {
  const ExactMotion motion(
      FreeBody(Vector3d(1, 2, 3).asDiagonal(), {0.01, 1, 0.02}, start_attitude));
  std::vector<double> X(9 * attitude_times.size()), omega(3 * attitude_times.size());
  motion.at(attitude_times, X, {});
  motion.at(attitude_times, {}, omega);
  for (std::size_t i = 0; i < attitude_times.size(); ++i) {
    const Sample sample = motion.at(attitude_times[i]);
    EXPECT_EQ(attitude_at(X, i), sample.X);
    EXPECT_EQ(Vector3d(&omega[3 * i]), sample.omega);
  }
}

/// Each step rounds the state, and each flip amplifies the error. docs/library.md states these
/// figures.
TEST(ExactStep, DriftsAsDocumentedWhenItIsRepeated) {
  for (const auto& [tilt, bound] : {std::pair{0.05, 2e-8}, std::pair{1e-3, 1e-5}}) {
    const FreeBody start(
        Vector3d(722.6710300807721, 982.2713030224087, 1578.650308428871).asDiagonal(),
        {tilt, 1, 0});
    FreeBody body = start;
    constexpr int steps = 100'000;
    for (int i = 0; i < steps; ++i) body = exact_step(body, 0.01);
    const Sample exact = ExactMotion(start).at(steps * 0.01);
    EXPECT_LE((body.attitude() - exact.X).norm() + (body.omega() - exact.omega).norm(), bound);
    EXPECT_LE((body.momentum() - start.momentum()).norm() / start.momentum().norm(), 1e-11);
    EXPECT_NEAR(energy(body.inertia(), body.omega()) / energy(start.inertia(), start.omega()), 1,
                1e-11);
  }
}

}  // namespace
}  // namespace twrench::motion
