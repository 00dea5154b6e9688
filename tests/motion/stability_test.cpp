#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>
#include <twrench/motion/stability.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "motion/random_bodies.h"

namespace twrench::motion {
namespace {

using Eigen::Vector3d;
using std::numbers::ln2;
using std::numbers::pi;

constexpr auto least = body::PrincipalAxes::least, intermediate = body::PrincipalAxes::intermediate,
               greatest = body::PrincipalAxes::greatest;

const Vector3d t_wrench(722.6710300807721, 982.2713030224087, 1578.650308428871);  // y, x, z

FreeBody wrench(const Vector3d& omega) {
  return {Vector3d(t_wrench[1], t_wrench[0], t_wrench[2]).asDiagonal(), omega};
}

TEST(Stability, OfTheTWrench) {
  const Stability about_x = stability(t_wrench, intermediate, 1);
  EXPECT_EQ(about_x.kind, Stability::Kind::unstable);
  EXPECT_NEAR(about_x.rate, 0.3684, 5e-5);
  EXPECT_NEAR(about_x.doubling_time(), 1.88, 5e-3);
  const Stability about_y = stability(t_wrench, least, 1),
                  about_z = stability(t_wrench, greatest, 1);
  EXPECT_EQ(about_y.kind, Stability::Kind::stable);
  EXPECT_NEAR(about_y.period(), 16.6, 0.05);
  EXPECT_EQ(about_z.kind, Stability::Kind::stable);
  EXPECT_NEAR(about_z.period(), 7.41, 5e-3);
}

TEST(Stability, IsThatOfTheLinearisedEquations) {
  RandomBodies random;
  for (int n = 0; n < 100; ++n) {
    Vector3d I = random.moments();
    std::ranges::sort(I);
    for (const auto k : body::PrincipalAxes::all) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const double square = 4 * (I[j] - I[k]) * (I[k] - I[i]) / (I[i] * I[j]);
      const auto [kind, rate] = stability(I, k, -2);
      EXPECT_EQ(kind, square > 0 ? Stability::Kind::unstable : Stability::Kind::stable);
      EXPECT_NEAR(rate * rate, std::abs(square), 1e-13 * std::abs(square));
    }
  }
}

TEST(Stability, IsNeutralWhereAMomentIsNotSingle) {
  for (const Vector3d& moments :
       {Vector3d(1, 1, 2), Vector3d(1, 1 + 1e-15, 2), Vector3d(1, 1 + 2e-9, 2),
        Vector3d(1, 1.00009, 2), Vector3d(2, 2, 2)}) {
    EXPECT_EQ(stability(moments, least, 1).kind, Stability::Kind::neutral);
    EXPECT_EQ(stability(moments, least, 1).rate, 0);
    EXPECT_EQ(stability(moments, intermediate, 1).kind, Stability::Kind::neutral);
  }
  EXPECT_EQ(stability({1, 1, 2}, greatest, 1).kind, Stability::Kind::stable);
  EXPECT_EQ(stability({1, 1 + 2e-9, 2}, greatest, 1).kind, Stability::Kind::stable);
  EXPECT_EQ(stability({1, 1.0002, 2}, intermediate, 1).kind, Stability::Kind::unstable);
  EXPECT_EQ(stability({1, 2, 3}, intermediate, 0).kind, Stability::Kind::neutral) << "at rest";
}

TEST(Tilt, GrowsAsPredicted) {
  // From 2e-9 to 2e-3 rad, where the decaying part no longer matters and the tilt is still small.
  for (const Vector3d& sideways : {Vector3d(0, 2e-9, 0), Vector3d(0, 0, 3e-9),
                                   Vector3d(0, -1e-9, 2e-9), Vector3d(0, 2e-9, 1e-9)}) {
    for (const double spin : {1.0, -1.7}) {
      const FreeBody body = wrench(Vector3d(spin, 0, 0) + sideways);
      const Tilt tilt(body);
      ASSERT_EQ(tilt.axis(), intermediate);
      const auto growth = tilt.growth();
      ASSERT_TRUE(growth);
      const ExactMotion motion(body);
      for (const double e_folds : {9.0, 11.0, 13.0}) {
        const double t = e_folds / growth->rate;
        const double predicted = growth->amplitude * std::exp(e_folds);
        EXPECT_NEAR(tilt.of(motion.at(t)) / predicted, 1, 1e-5) << spin << " " << e_folds;
      }
    }
  }
}

TEST(Tilt, DoublesInTheDoublingTime) {
  const FreeBody body = wrench({1, 1e-7, 0});
  const ExactMotion motion(body);
  const Tilt tilt(body);
  const double t = 20;
  EXPECT_NEAR(tilt.of(motion.at(t + ln2 / 0.3683837)) / tilt.of(motion.at(t)), 2, 1e-5);
}

TEST(Tilt, OfAStableSpinHasThePredictedPeriod) {
  const FreeBody body = wrench({1e-6, 1, 2e-6});
  const Tilt tilt(body);
  EXPECT_EQ(tilt.axis(), least);
  EXPECT_FALSE(tilt.growth());
  const ExactMotion motion(body);
  const double period = stability(t_wrench, least, tilt.steady_rate()).period();
  for (const double t : {0.0, 3.0, 10.0}) {
    EXPECT_NEAR(tilt.of(motion.at(t + period)), tilt.of(motion.at(t)), 1e-11);
  }
}

TEST(Tilt, IsTheAngleToEitherEndOfTheAxis) {
  const FreeBody body = wrench({1, 0.05, 0});
  const Tilt tilt(body);
  const ExactMotion motion(body);
  const auto flips = motion.flips();
  ASSERT_TRUE(flips);
  EXPECT_NEAR(tilt.of(motion.at(flips->first)), pi / 2, 1e-9) << "turning over";
  EXPECT_NEAR(tilt.of(motion.at(0)), std::atan(0.05 * t_wrench[0] / t_wrench[1]), 1e-12);
  for (const double t : {0.0, 7.0, 15.0, 30.0}) {
    const Sample sample = motion.at(t);
    const double cosine = std::abs(sample.X.col(0).dot(body.momentum().normalized()));
    EXPECT_NEAR(std::cos(tilt.of(sample)), cosine, 1e-12) << t;
  }
  EXPECT_NEAR(tilt.of(motion.at(2 * flips->first)), tilt.of(motion.at(0)), 1e-9) << "the other end";
  EXPECT_EQ(tilt.from_start(motion.at(0)), tilt.of(motion.at(0)));
  EXPECT_NEAR(tilt.from_start(motion.at(2 * flips->first)), pi - tilt.of(motion.at(0)), 1e-9);
}

TEST(Tilt, GrowsWhereTheBodyTurnsInItsDirection) {
  for (const Vector3d& omega :
       {Vector3d(1, 0.05, 0), Vector3d(-1, 0.1, 0.3), Vector3d(0.1, 0.2, -1)}) {
    const FreeBody body = wrench(omega);
    const Tilt tilt(body);
    const Sample sample = ExactMotion(body).at(3);
    const Vector3d direction = tilt.direction(sample);
    EXPECT_NEAR(direction.norm(), 1, 1e-14);
    // The body is turned by an angle about its own axes; L is unchanged.
    Sample turned = sample;
    turned.X = sample.X * so3::exp(0.01 * direction);
    turned.omega = body.inverse() * turned.X.transpose() * body.momentum();
    EXPECT_NEAR(tilt.of(turned), tilt.of(sample) + 0.01, 1e-12);
  }
  const FreeBody steady = wrench({0, 0, 1});
  EXPECT_EQ(Tilt(steady).direction(ExactMotion(steady).at(1)), Vector3d::Zero());
}

// The sums in docs/theory.md: of the leg, of the handle, and the growth rate of both together.
TEST(Tilt, OfTheTWrenchIsMadeToGrowByTheLeg) {
  const std::array parts{
      body::Part{body::Cylinder{1, 4}, 6.7, {2, 0, 0}, body::frame_with_z_along({1, 0, 0})},
      body::Part{body::Cylinder{1, 8}, 6.7, {-1, 0, 0}, body::frame_with_z_along({0, 1, 0})}};
  const FreeBody body = wrench({1, 1e-7, 0});
  const Tilt tilt(body);
  const Sample sample = ExactMotion(body).at(20);
  const FrameForces forces(steady_frame(body, 20), body, sample);
  const Vector3d direction =
      steady_frame(body, 20).attitude.transpose() * sample.X * tilt.direction(sample);
  std::array<double, 2> torque{}, coriolis{};
  for (std::size_t i = 0; i < 2; ++i) {
    for (const auto& [mass, position] : body::equimomental_points(parts[i])) {
      const PointForces on = forces.on(mass, position);
      torque[i] += direction.dot(on.position.cross(on.centrifugal)) / tilt.of(sample);
      coriolis[i] += direction.dot(on.position.cross(on.coriolis)) / tilt.of(sample);
    }
  }
  EXPECT_NEAR(torque[0], 428, 0.5);
  EXPECT_NEAR(torque[1], -270, 0.5);
  EXPECT_NEAR(coriolis[0], 0, 0.1);
  EXPECT_NEAR(coriolis[1], 0, 0.1);
}

TEST(Tilt, OfABodyAtRestIsZero) {
  const FreeBody body = wrench(Vector3d::Zero());
  EXPECT_EQ(Tilt(body).of({0, Eigen::Matrix3d::Identity(), Vector3d::Zero()}), 0);
  EXPECT_EQ(Tilt(body).steady_rate(), 0);
  EXPECT_FALSE(Tilt(body).growth());
}

}  // namespace
}  // namespace twrench::motion
