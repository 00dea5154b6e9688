// The geometric phase: how far a body turns about L in one period of its momentum.
#include "motion/phase.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "motion/bodies_of_every_kind.h"
#include "sanitizers.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Returns the angle of X(T) X(0)^T about L, up to whole turns, and expects that it is a rotation
/// about L.
double angle_about(const FreeBody& body, const Matrix3d& turn) {
  const Vector3d axis = body.momentum().normalized(), u = so3::log(turn);
  EXPECT_LE(u.cross(axis).norm(), 1e-9);
  return u.dot(axis);
}

/// Returns the integral of (1 - cos(angle)) d(azimuth) about the axis that the momentum circles.
/// For a smooth periodic function, the sum over equal steps converges faster than any power of
/// their number.
double area_by_quadrature(const FreeBody& body, const Vector3d& half_axis, double period) {
  const ExactMotion motion(body);
  constexpr int steps = 1 << 14;
  const double G = body.momentum().norm();
  double area = 0;
  for (int i = 0; i < steps; ++i) {
    const Sample sample = motion.at(period * i / steps);
    const Vector3d mu = sample.X.transpose() * body.momentum() / G, change = mu.cross(sample.omega);
    const double along = mu.dot(half_axis);
    const double azimuth_rate = half_axis.dot(mu.cross(change)) / (1 - along * along);
    area += (1 - along) * azimuth_rate * period / steps;
  }
  return area;
}

// From SciPy: DOP853 over a period, and the area by quadrature.
TEST(Phase, HasTheKnownParts) {
  const Vector3d moments(3, 5, 9), L(0, 2, 0.01);
  const auto phase = ExactMotion(FreeBody(moments.asDiagonal(), L.cwiseQuotient(moments))).phase();
  ASSERT_TRUE(phase);
  EXPECT_NEAR(phase->period, 118.1109, 5e-5);
  EXPECT_NEAR(phase->dynamic, 47.2444204, 5e-8);
  EXPECT_NEAR(phase->area(), 2.7385939, 5e-8);
  EXPECT_NEAR(phase->total, 44.5058265, 5e-8);
}

TEST(Phase, IsTheTurnOfTheExactMotion) {
  const Matrix3d attitude = so3::exp({0.3, -1.1, 0.7});
  int count = 0;
  for (const BodyOfAKind& b : bodies_of_every_kind()) {
    const FreeBody body(b.moments.asDiagonal(), b.omega, attitude);
    const ExactMotion motion(body);
    const auto phase = motion.phase();
    if (!phase || phase->total > 1e4) continue;
    ++count;
    const double angle = angle_about(body, motion.at(phase->period).X * attitude.transpose());
    EXPECT_LE(std::abs(std::remainder(phase->total - angle, 2 * pi)), 1e-13 * (1 + phase->total))
        << b.moments.transpose() << ", " << b.omega.transpose();
  }
  EXPECT_GT(count, 50);
}

TEST(Phase, GeometricPartIsTheAreaOnBothSidesOfTheSeparatrix) {
  const Vector3d moments(3, 5, 9);
  for (const double side : {1.0, -1.0}) {
    for (const Vector3d& omega : {Vector3d(0.2, 1, 0.02), Vector3d(1, 0.3, 0.1),
                                  Vector3d(0.02, 1, 0.3), Vector3d(0.1, 0.2, 1)}) {
      const FreeBody body(moments.asDiagonal(), side * omega);
      const ExactMotion motion(body);
      const bool least = motion.kind() == ExactMotion::Kind::about_least;
      const auto phase = motion.phase();
      ASSERT_TRUE(phase);
      const double area =
          area_by_quadrature(body, side * Vector3d::Unit(least ? 0 : 2), phase->period);
      EXPECT_NEAR(phase->area(), area, 1e-10);
      EXPECT_EQ(area < 0, least);
    }
  }
}

TEST(Phase, OfASymmetricBodyWithAWheelToo) {
  for (const double spin : {0.4, -0.4}) {
    const FreeBody body(Vector3d(2, 2, 3).asDiagonal(), {0.3, 0.1, spin}, Matrix3d::Identity(),
                        {.wheel = {0, 0, 1.5}});
    const ExactMotion motion(body);
    const auto phase = motion.phase();
    ASSERT_TRUE(phase);
    const double angle = angle_about(body, motion.at(phase->period).X);
    EXPECT_NEAR(std::remainder(phase->total - angle, 2 * pi), 0,
                1e-13 * (1 + std::abs(phase->total)));
    EXPECT_NEAR(phase->area(), area_by_quadrature(body, Vector3d::UnitZ(), phase->period), 1e-10);
  }
}

// A wheel this small changes no digit, but the motion is integrated.
TEST(Phase, OfAVanishingWheelIsThatOfTheRigidBody) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const Vector3d& omega : {Vector3d(0.2, 1, 0.02), Vector3d(1, 0.3, 0.1),
                                  Vector3d(0.02, -1, 0.3), Vector3d(-0.1, 0.2, -1)}) {
      const Matrix3d inertia = scale * Vector3d(3, 5, 9).asDiagonal();
      const Matrix3d attitude = so3::exp({0.3, -1.1, 0.7});
      const auto rigid = ExactMotion(FreeBody(inertia, scale * omega, attitude)).phase();
      const auto found =
          phase_of(FreeBody(inertia, scale * omega, attitude, {.wheel = {1e-200, 0, 0}}));
      ASSERT_TRUE(rigid && found);
      EXPECT_NEAR(found->period, rigid->period, 1e-11 * rigid->period);
      EXPECT_NEAR(found->total, rigid->total, 1e-11 * (1 + rigid->total));
      EXPECT_NEAR(found->area(), rigid->area(), 1e-10);
    }
  }
}

// The motion itself returns turned about L by the angle; the dynamic part and the area are sums
// over equal steps, as above.
TEST(Phase, OfABodyWithAWheelIsTheTurnOfItsMotion) {
  constexpr int steps = 1 << 12;
  for (const Vector3d& wheel : {Vector3d(0.5, 0.2, -0.3), Vector3d(0, 2, 0), Vector3d(0, 0, -7)}) {
    for (const Vector3d& omega : {Vector3d(0.2, 1, 0.02), Vector3d(1, 0.3, 0.1)}) {
      const FreeBody body(Vector3d(3, 5, 9).asDiagonal(), omega, Matrix3d::Identity(),
                          {.wheel = wheel});
      const auto phase = phase_of(body);
      ASSERT_TRUE(phase);
      std::vector<double> times;
      for (int i = 0; i <= steps; ++i) times.push_back(phase->period * i / steps);
      const auto samples =
          integrate(body, find_method("taylor"), {.tolerance = min_tolerance}, times).samples;
      const double G = body.momentum().norm();
      const auto mu = [&](const Sample& s) {
        return Vector3d(s.X.transpose() * body.momentum() / G);
      };
      EXPECT_LE((mu(samples.back()) - mu(samples.front())).norm(), 1e-11);
      const double angle = angle_about(body, samples.back().X);
      EXPECT_NEAR(std::remainder(phase->total - angle, 2 * pi), 0, 1e-11 * (1 + phase->total));
      Vector3d middle = Vector3d::Zero();
      for (int i = 0; i < steps; ++i) middle += mu(samples[static_cast<std::size_t>(i)]);
      middle.normalize();
      double dynamic = 0, area = 0;
      for (int i = 0; i < steps; ++i) {
        const Sample& s = samples[static_cast<std::size_t>(i)];
        const Vector3d m = mu(s);
        const double along = m.dot(middle);
        dynamic += m.dot(s.omega) * phase->period / steps;
        area += middle.dot(m.cross(m.cross(s.omega))) / (1 + along) * phase->period / steps;
      }
      EXPECT_NEAR(phase->dynamic, dynamic, 1e-10 * (1 + std::abs(dynamic)));
      EXPECT_NEAR(phase->area(), area, 1e-10);
    }
  }
}

TEST(Phase, IsThatOfAClosedPathAlone) {
  const auto phase = [](const Vector3d& moments, const Vector3d& omega) {
    return ExactMotion(FreeBody(moments.asDiagonal(), omega)).phase();
  };
  EXPECT_FALSE(phase({1, 2, 3}, {0, 0, 1}));
  EXPECT_FALSE(phase({1, 2, 3}, {0, 0, 0}));
  EXPECT_FALSE(phase({1, 4, 6}, {2, 0, 1})) << "the separatrix";
  const auto of = [](const Vector3d& omega, const Interior& interior) {
    return phase_of(
        FreeBody(Vector3d(3, 5, 9).asDiagonal(), omega, Matrix3d::Identity(), interior));
  };
  EXPECT_TRUE(of({0.1, 1, 0}, {.wheel = {0, 1, 0}}));
  EXPECT_FALSE(of({0, 1, 0}, {.wheel = {0, 1, 0}})) << "steady";
  if (!has_sanitizers) {  // its motion takes a hundred times as many steps
    EXPECT_FALSE(of({1e-11, 1, 0}, {.wheel = {0, 1, 0}})) << "at the saddle";
  }
  EXPECT_FALSE(of({0, 1, 0}, {.wheel = {0, -5, 0}})) << "no momentum";
  EXPECT_FALSE(of({0.1, 1, 0}, {.energy_loss_time = 50}));
}

}  // namespace
}  // namespace twrench::motion
