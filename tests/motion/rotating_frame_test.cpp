// Compares the forces in a frame with finite differences of the positions from the closed form.
#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stability.h>

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <vector>

#include "motion/bodies_of_every_kind.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using FrameAt = std::function<RotatingFrame(const FreeBody&, const Sample&)>;

struct NamedFrame {
  const char* name;
  FrameAt at;
};

const std::vector<NamedFrame>& every_frame() {
  static const std::vector<NamedFrame> frames{
      {"space", [](const FreeBody&, const Sample&) { return RotatingFrame{}; }},
      {"body", [](const FreeBody& body, const Sample& sample) { return body_frame(body, sample); }},
      {"steady",
       [](const FreeBody& body, const Sample& sample) { return steady_frame(body, sample.t); }}};
  return frames;
}

struct Derivatives {
  Vector3d first, second;
};

/// Returns the central differences of order 20. Their weights follow from the interpolating
/// polynomial.
Derivatives differences(const std::function<Vector3d(double)>& place, double t, double h) {
  constexpr int reach = 10;
  Derivatives sum{Vector3d::Zero(), Vector3d::Zero()};
  const Vector3d here = place(t);
  double ratio = 1;  // (n!)^2 / ((n - k)! (n + k)!)
  for (int k = 1; k <= reach; ++k) {
    ratio *= static_cast<double>(reach - k + 1) / (reach + k);
    const double weight = (k % 2 == 1 ? 2 : -2) * ratio;
    const Vector3d ahead = place(t + k * h), behind = place(t - k * h);
    sum.first += weight / (2 * k * h) * (ahead - behind);
    sum.second += weight / (k * k * h * h) * ((ahead - here) + (behind - here));
  }
  return sum;
}

/// Returns a rate in rad/s that nothing in the motion exceeds by much.
double fastest(const FreeBody& body) {
  const Vector3d& moments = body.principal().moments;
  return body.omega().norm() + body.momentum().norm() / moments[1];
}

class EveryBodyInEveryFrame : public testing::TestWithParam<std::size_t> {
 protected:
  const BodyOfAKind kind = bodies_of_every_kind()[GetParam()];
  const FreeBody body{kind.moments.asDiagonal(), kind.omega};
  const ExactMotion motion{body};
};

TEST_P(EveryBodyInEveryFrame, TheForcesAddUpToMassTimesAcceleration) {
  const double rate = fastest(body);
  const double t = rate > 0 ? 3 / rate : 3;
  for (const auto& [name, frame_at] : every_frame()) {
    const auto place = [&, &at = frame_at](const Vector3d& r, double time) -> Vector3d {
      const Sample sample = motion.at(time);
      return at(body, sample).attitude.transpose() * (sample.X * r);
    };
    const Sample sample = motion.at(t);
    const FrameForces forces(frame_at(body, sample), body, sample);
    for (const Vector3d& r : {Vector3d(1, 0, 0), Vector3d(0.3, -2, 0.5), Vector3d(-0.1, 0.2, 3)}) {
      const double mass = 2.5, h = rate > 0 ? 0.15 / rate : 0.1;
      const PointForces on = forces.on(mass, r);
      const auto [velocity, acceleration] =
          differences([&](double time) { return place(r, time); }, t, h);
      const Vector3d sum = on.centrifugal + on.coriolis + on.euler + on.constraint;
      const double size = mass * rate * rate * r.norm();
      EXPECT_LE((on.position - place(r, t)).norm(), 1e-15 * r.norm()) << name;
      EXPECT_LE((on.velocity - velocity).norm(), 1e-12 * rate * r.norm()) << name;
      EXPECT_LE((on.acceleration - acceleration).norm(), 1e-12 * rate * rate * r.norm()) << name;
      EXPECT_LE((sum - mass * acceleration).norm(), 1e-12 * size) << name;
    }
  }
}

TEST_P(EveryBodyInEveryFrame, TheFramesTurnAsTheySay) {
  const double rate = fastest(body);
  if (rate == 0) return;
  const double t = 3 / rate, h = 0.15 / rate;
  for (const auto& [name, frame_at] : every_frame()) {
    const auto at = [&, &frame = frame_at](double time) { return frame(body, motion.at(time)); };
    const RotatingFrame now = at(t);
    for (int i = 0; i < 3; ++i) {
      const auto axis = differences([&](double s) { return at(s).attitude.col(i).eval(); }, t, h);
      const Vector3d turned = now.attitude * now.omega.cross(Vector3d::Unit(i));
      EXPECT_LE((axis.first - turned).norm(), 1e-12 * rate) << name;
    }
    const auto omega = differences([&](double s) { return at(s).omega; }, t, h);
    EXPECT_LE((omega.first - now.alpha).norm(), 1e-12 * rate * rate) << name;
    EXPECT_LE((at(0).attitude - Matrix3d::Identity()).norm(), 1e-15) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryBodyInEveryFrame,
                         testing::Range(std::size_t{0}, bodies_of_every_kind().size()));

TEST(RotatingFrame, OfTheBodyHasNoCoriolisForce) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.1, 1, -0.3});
  const Sample sample = ExactMotion(body).at(4.5);
  const PointForces on = FrameForces(body_frame(body, sample), body, sample).on(2, {1, -2, 0.5});
  EXPECT_LE((on.position - Vector3d(1, -2, 0.5)).norm(), 1e-14);
  EXPECT_LE(on.velocity.norm(), 1e-14);
  EXPECT_LE(on.coriolis.norm(), 1e-14);
  EXPECT_LE((on.centrifugal + on.euler + on.constraint).norm(), 1e-13);
  EXPECT_GT(on.euler.norm(), 0.1);
}

TEST(RotatingFrame, OfASteadyRotationIsThatOfTheBody) {
  const FreeBody body(Vector3d(2, 3, 4).asDiagonal(), {0, -1.5, 0});
  const Sample sample = ExactMotion(body).at(7);
  const RotatingFrame frame = steady_frame(body, 7);
  EXPECT_LE((frame.attitude - sample.X).norm(), 1e-14);
  EXPECT_LE((frame.omega - Vector3d(0, -1.5, 0)).norm(), 1e-15);
  EXPECT_EQ(frame.alpha, Vector3d::Zero());
  EXPECT_LE(FrameForces(frame, body, sample).on(1, {1, 2, 3}).coriolis.norm(), 1e-13);
}

TEST(RotatingFrame, TurnsAboutTheMomentumEvenOfANeedleThatTumbles) {
  const FreeBody body(Vector3d(1e-9, 1, 1).asDiagonal(), {2, 1, 0});
  EXPECT_NEAR(steady_frame(body, 1).omega.norm(), 1, 1e-8) << "not |L| / 1e-9";
}

TEST(RotatingFrame, OfABodyAtRestIsInertial) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), Vector3d::Zero());
  const RotatingFrame frame = steady_frame(body, 5);
  EXPECT_EQ(frame.attitude, Matrix3d::Identity());
  EXPECT_EQ(frame.omega, Vector3d::Zero());
}

TEST(RotatingFrame, OfASampleThatIsNoRotationIsOneYet) {
  const FreeBody body(Vector3d(1, 2, 3).asDiagonal(), {0.1, 1, -0.3});
  const Matrix3d X = so3::exp(Vector3d(0.3, 2, -1));
  const Matrix3d attitude = body_frame(body, {1, 30 * X, {0.1, 1, -0.3}}).attitude;
  EXPECT_LE((attitude.transpose() * attitude - Matrix3d::Identity()).norm(), 1e-14);
}

std::vector<body::Part> wrench_and_more() {
  return {{body::Cylinder{1, 8}, 6.7, {-1, 0, 0}, body::frame_with_z_along({0, 1, 0})},
          {body::Cylinder{1, 4}, 6.7, {2, 0, 0}, body::frame_with_z_along({1, 0, 0})},
          {body::Box{{1, 2, 3}}, 2, {1, 1, 1}, so3::exp(Vector3d(0.3, 0.2, -1))},
          {body::Ellipsoid{{1, 0.5, 2}}, 5, {0, 3, -2}, so3::exp(Vector3d(-2, 0.1, 0.7))}};
}

/// The sum of the torques about the centre of mass, along the frame's axes.
struct Torques {
  Vector3d centrifugal = Vector3d::Zero(), coriolis = centrifugal, euler = centrifugal,
           constraint = centrifugal, force = centrifugal;
};

Torques torques(std::vector<body::Part> parts, const Vector3d& centre, const FrameForces& forces) {
  Torques sum;
  for (body::Part& part : parts) {
    part.position -= centre;
    for (const auto& [mass, position] : body::equimomental_points(part)) {
      const PointForces on = forces.on(mass, position);
      sum.centrifugal += on.position.cross(on.centrifugal);
      sum.coriolis += on.position.cross(on.coriolis);
      sum.euler += on.position.cross(on.euler);
      sum.constraint += on.position.cross(on.constraint);
      sum.force += on.constraint;
    }
  }
  return sum;
}

// With S the integral of r r^T dm, that of r x (a x (b x r)) dm is S a x b, and S = tr(I)/2 - I.
TEST(RotatingFrame, TheTorquesOnThePartsAreTheIntegrals) {
  const std::vector<body::Part> parts = wrench_and_more();
  const body::MassProperties properties = body::mass_properties(parts);
  const FreeBody body(properties.inertia, {1, 0.4, -0.3});
  const Sample sample = ExactMotion(body).at(2);
  for (const auto& [name, frame_at] : every_frame()) {
    const RotatingFrame frame = frame_at(body, sample);
    const Torques sum = torques(parts, properties.centre_of_mass, FrameForces(frame, body, sample));
    const Matrix3d R = frame.attitude.transpose() * sample.X;
    const Matrix3d I = R * body.inertia() * R.transpose();
    const Vector3d u = R * sample.omega - frame.omega;  // of the body relative to the frame
    const double size = body.inertia().norm();
    EXPECT_LE((sum.centrifugal + frame.omega.cross(I * frame.omega)).norm(), 1e-14 * size) << name;
    EXPECT_LE((sum.euler + I * frame.alpha).norm(), 1e-14 * size) << name;
    EXPECT_LE(sum.force.norm(), 1e-14 * size) << name << ": the centre of mass is at rest";
    EXPECT_LE(sum.constraint.norm(), 1e-14 * size) << name << ": nothing touches it";
    const Matrix3d S = 0.5 * I.trace() * Matrix3d::Identity() - I;
    const Vector3d coriolis = -2 * (S * frame.omega).cross(u);
    EXPECT_LE((sum.coriolis - coriolis).norm(), 1e-14 * size) << name;
  }
}

}  // namespace
}  // namespace twrench::motion
