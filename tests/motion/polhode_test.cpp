#include <gtest/gtest.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/polhode.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::motion {
namespace {

using Eigen::Vector3d;

const Vector3d wrench_moments(723, 982, 1579);
constexpr int points = 97;

double angle(int i) { return 2 * std::numbers::pi * i / points; }

double energy_of(const Vector3d& moments, const Vector3d& mu) {
  return (mu.array().square() / moments.array()).sum();
}

FreeBody body(const Vector3d& moments, const Vector3d& omega) {
  return FreeBody(moments.asDiagonal(), omega);
}

TEST(Polhode, LiesOnTheSphereAndOnTheEllipsoidOfEnergy) {
  const auto levels = level_family(wrench_moments, 4);
  ASSERT_EQ(levels.size(), 16);
  for (const EnergyLevel& level : levels) {
    EXPECT_FALSE(level.is_separatrix());
    for (int i = 0; i < points; ++i) {
      const Vector3d mu = level.at(angle(i));
      EXPECT_NEAR(mu.norm(), 1, 1e-14);
      EXPECT_NEAR(energy_of(wrench_moments, mu) / level.energy, 1, 1e-13);
      EXPECT_GT(level.side * mu[level.axis], 0);
    }
  }
}

TEST(Polhode, GoesThroughTheMomentumItIsAskedFor) {
  for (const Vector3d& omega : {Vector3d(0.05, 1, 0), Vector3d(0, 1, -0.05), Vector3d(-1, 0.3, 0.1),
                                Vector3d(0.1, 0.2, -1), Vector3d(0, 0, 1)}) {
    const Vector3d mu = wrench_moments.cwiseProduct(omega).normalized();
    const auto level = level_through(wrench_moments, mu);
    ASSERT_TRUE(level);
    double nearest = 2;
    for (int i = 0; i < 4096; ++i) {
      nearest = std::min(nearest, (level->at(2 * std::numbers::pi * i / 4096) - mu).norm());
    }
    EXPECT_LT(nearest, 2e-3) << omega.transpose();
  }
}

TEST(Polhode, OfTheSeparatrixAreTwoGreatCirclesThroughTheIntermediateAxis) {
  const auto circles = separatrix(wrench_moments);
  ASSERT_TRUE(circles);
  for (const Vector3d& side : *circles) {
    EXPECT_NEAR(side.norm(), 1, 1e-15);
    EXPECT_EQ(side.y(), 0);
    for (int i = 0; i < points; ++i) {
      const Vector3d mu = std::cos(angle(i)) * Vector3d::UnitY() + std::sin(angle(i)) * side;
      EXPECT_NEAR(energy_of(wrench_moments, mu) * wrench_moments.y(), 1, 1e-14);
    }
  }
  EXPECT_GT(((*circles)[0] - (*circles)[1]).norm(), 0.1);
  const auto level = level_through(wrench_moments, (*circles)[0]);
  ASSERT_TRUE(level);
  EXPECT_TRUE(level->is_separatrix());
}

TEST(Polhode, OfASymmetricBodyIsACircleAboutItsAxis) {
  for (const Vector3d& moments : {Vector3d(1, 1, 1.7), Vector3d(0.3, 1, 1)}) {
    EXPECT_FALSE(separatrix(moments));
    const int axis = moments[0] == moments[1] ? 2 : 0;
    const auto levels = level_family(moments, 3);
    EXPECT_EQ(levels.size(), 6);
    const Vector3d mu = Vector3d(0.3, -0.5, 0.6).normalized();
    const auto level = level_through(moments, mu);
    ASSERT_TRUE(level);
    for (int i = 0; i < points; ++i) EXPECT_NEAR(level->at(angle(i))[axis], mu[axis], 1e-14);
  }
}

TEST(Polhode, OfASphereIsAPoint) {
  const Vector3d moments = Vector3d::Constant(2);
  EXPECT_FALSE(level_through(moments, Vector3d::UnitX()));
  EXPECT_FALSE(separatrix(moments));
  EXPECT_TRUE(level_family(moments, 3).empty());
}

TEST(Polhode, StaysFiniteForMomentsFarApart) {
  for (const Vector3d& moments : {Vector3d(1e-6, 1, 1e6), Vector3d(1, 1 + 1e-12, 1e9)}) {
    for (const EnergyLevel& level : level_family(moments, 2)) {
      EXPECT_TRUE(level.at(1).allFinite());
      EXPECT_TRUE(std::isfinite(herpolhode_annulus(level).outer));
    }
  }
}

TEST(Herpolhode, StaysInItsAnnulusAndReachesBothRims) {
  for (const Vector3d& omega : {Vector3d(0.05, 1, 0), Vector3d(1, 0.3, 0.2), Vector3d(0, 0.4, 1)}) {
    const FreeBody free = body(wrench_moments, omega);
    const ExactMotion motion(free);
    const Vector3d up = free.momentum().normalized();
    const auto level =
        level_through(free.principal().moments, free.principal().axes.transpose() * up);
    ASSERT_TRUE(level);
    const auto [inner, outer] = herpolhode_annulus(*level);
    double least = 1e9, most = 0;
    for (int i = 0; i < 4000; ++i) {
      const Sample sample = motion.at(0.02 * i);
      const Vector3d tip = sample.X * sample.omega / omega.dot(up);
      EXPECT_NEAR(tip.dot(up), 1, 1e-9);
      const double radius = (tip - up).norm();
      least = std::min(least, radius);
      most = std::max(most, radius);
    }
    EXPECT_NEAR(least, inner, 1e-3);
    EXPECT_NEAR(most, outer, 1e-3);
    EXPECT_GE(least, inner - 1e-6);
    EXPECT_LE(most, outer + 1e-6);
  }
}

}  // namespace
}  // namespace twrench::motion
