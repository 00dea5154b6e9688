// The curves of constant energy of a body with a wheel.
#include "motion/energy_contours.h"

#include <gtest/gtest.h>
#include <twrench/motion/polhode.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <cmath>

#include "motion/random_bodies.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using PointKind = EnergyContours::Kind;

FreeBody body_with(const Vector3d& moments, const Vector3d& omega, const Vector3d& wheel) {
  return {moments.asDiagonal(), omega, Matrix3d::Identity(), {.wheel = wheel}};
}

std::ptrdiff_t count(const EnergyContours& contours, PointKind kind) {
  return std::ranges::count(contours.equilibria(), kind, &EnergyContours::Equilibrium::kind);
}

double distance(const EnergyContours::Curve& curve, const Vector3d& point) {
  double least = 9;
  for (const Vector3d& other : curve) least = std::min(least, (other - point).norm());
  return least;
}

TEST(EnergyContours, HasTheAxesOfARigidBodyAsEquilibria) {
  const EnergyContours contours(body_with({3, 4, 5}, {0.1, 1, 0.2}, {0, 0, 0}));
  ASSERT_EQ(contours.equilibria().size(), 6U);
  const std::array kinds{PointKind::minimum, PointKind::saddle, PointKind::maximum};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& [mu, kind] = contours.equilibria()[i];
    EXPECT_EQ(kind, kinds[i / 2]);
    EXPECT_EQ(std::abs(mu[2 - static_cast<int>(i / 2)]), 1);
  }
}

/// Landau and Lifshitz' curves, in closed form.
TEST(EnergyContours, HasTheLevelsOfARigidBody) {
  const Vector3d moments(3, 4, 5);
  const FreeBody body = body_with(moments, {0.1, 1, 0.2}, {0, 0, 0});
  const EnergyContours contours(body);
  for (const EnergyLevel& level : level_family(moments, 3)) {
    const EnergyContours::Curve curve = contours.through(level.at(0.4));
    EXPECT_EQ(curve.front(), curve.back());
    for (double phi = 0; phi < 6.2; phi += 0.1) {
      EXPECT_LT(distance(curve, level.at(phi)), 0.013);  // half a step
    }
    for (const Vector3d& mu : curve) {
      EXPECT_NEAR(contours.energy(mu), contours.energy(level.at(0)), 1e-13);
    }
  }
  const auto circles = separatrix(moments).value();
  ASSERT_EQ(contours.separatrices().size(), 4U);
  for (const EnergyContours::Curve& curve : contours.separatrices()) {
    EXPECT_NEAR(std::abs(curve.front().y()), 1, 1e-12);
    EXPECT_NEAR(curve.front().y(), -curve.back().y(), 1e-12);
    for (const Vector3d& mu : curve) {
      const auto off = [&](const Vector3d& side) {
        return std::abs(mu.dot(side.cross(Vector3d::UnitY())));
      };
      EXPECT_LT(std::min(off(circles[0]), off(circles[1])), 1e-4);
    }
  }
}

/// The Euler characteristic of the sphere: extrema - saddles = 2. All are at rest.
TEST(EnergyContours, HasTwoFourOrSixEquilibria) {
  RandomBodies random;
  std::array<int, 7> seen{};
  for (int n = 0; n < 400; ++n) {
    Vector3d moments = random.moments();
    std::ranges::sort(moments);
    const Vector3d omega = random.omega();
    const Vector3d wheel =
        std::exp2(-n % 8) * moments.cwiseProduct(random.omega()) * (n % 9 == 0 ? 0 : 1);
    const FreeBody body = body_with(moments, omega, wheel);
    const EnergyContours contours(body);
    const std::size_t size = contours.equilibria().size();
    ASSERT_TRUE(size == 2 || size == 4 || size == 6) << n;
    ++seen[size];
    EXPECT_EQ(static_cast<std::ptrdiff_t>(size) - 2 * count(contours, PointKind::saddle), 2) << n;
    EXPECT_GE(count(contours, PointKind::minimum), 1);
    EXPECT_GE(count(contours, PointKind::maximum), 1);
    for (const auto& [own, kind] : contours.equilibria()) {
      const Vector3d m = body.momentum().norm() * (body.principal().axes * own);
      const Vector3d torque = m.cross(body.rigid_velocity(m));
      const double scale = m.norm() * (m.norm() + wheel.norm()) / moments[0];
      EXPECT_LT(torque.norm(), 1e-10 * scale) << n;
    }
  }
  EXPECT_GT(seen[2], 10);
  EXPECT_GT(seen[4], 10);
  EXPECT_GT(seen[6], 10);
}

TEST(EnergyContours, HasTwoEquilibriaForASphereWithAWheel) {
  const EnergyContours contours(body_with({2, 2, 2}, {0.1, 1, 0.2}, {1, -2, 2}));
  ASSERT_EQ(contours.equilibria().size(), 2U);
  EXPECT_LT((contours.equilibria()[0].mu - Vector3d(1, -2, 2) / 3).norm(), 1e-12);
  EXPECT_EQ(count(contours, PointKind::maximum), 1);
}

/// The momentum of an integrated motion stays on its curve and passes all parts of it.
TEST(EnergyContours, IsWhereTheMomentumMoves) {
  for (const Vector3d& wheel : {Vector3d(0.5, 0.3, -0.4), Vector3d(0, 3, 0), Vector3d(2, 0, 0)}) {
    const FreeBody body = body_with({3, 4, 5}, {0.1, 1, 0.2}, wheel);
    const Vector3d start = body.body_momentum().normalized();
    const EnergyContours::Curve curve = EnergyContours(body).through(start);
    std::vector<double> times;
    for (int i = 0; i < 4000; ++i) times.push_back(0.02 * i);
    EnergyContours::Curve path;
    for (const Sample& s : integrate(body, find_method("taylor"), {}, times).samples) {
      path.push_back((s.X.transpose() * body.momentum()).normalized());
      EXPECT_LT(distance(curve, path.back()), 0.013) << wheel.transpose();
    }
    for (const Vector3d& mu : curve) EXPECT_LT(distance(path, mu), 0.02) << wheel.transpose();
  }
}

TEST(EnergyContours, CoversTheSphere) {
  constexpr double spacing = 0.25;
  for (const Vector3d& wheel : {Vector3d(0, 0, 0), Vector3d(0.5, 0.3, -0.4), Vector3d(9, 0, 3)}) {
    const EnergyContours contours(body_with({3, 4, 5}, {0.1, 1, 0.2}, wheel));
    const auto levels = contours.family(spacing);
    EXPECT_LT(levels.size(), 60U);
    for (int i = 0; i < 200; ++i) {  // a spiral over the sphere
      const double z = -1 + (2 * i + 1) / 200.0, r = std::sqrt(1 - z * z);
      const Vector3d mu(r * std::cos(2.4 * i), r * std::sin(2.4 * i), z);
      double least = 9;
      for (const auto& level : levels) least = std::min(least, distance(level.curve, mu));
      for (const auto& e : contours.equilibria()) least = std::min(least, (e.mu - mu).norm());
      EXPECT_LT(least, 2 * spacing) << wheel.transpose() << " " << mu.transpose();
    }
  }
}

}  // namespace
}  // namespace twrench::motion
