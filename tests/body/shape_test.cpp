#include <gtest/gtest.h>
#include <twrench/body/shape.h>

#include <Eigen/LU>
#include <numbers>
#include <random>

namespace twrench::body {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// The integral of (1, x^2, y^2, z^2) over the shape, by the midpoint rule on a grid.
Eigen::Vector4d integrate(const Vector3d& half, auto&& inside) {
  constexpr int n = 120;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const Vector3d u((2 * i + 1.0) / n - 1, (2 * j + 1.0) / n - 1, (2 * k + 1.0) / n - 1);
        const Vector3d p = u.cwiseProduct(half);
        if (inside(p)) sum += Eigen::Vector4d(1, p.x() * p.x(), p.y() * p.y(), p.z() * p.z());
      }
    }
  }
  return sum * (8 * half.prod() / (static_cast<double>(n) * n * n));
}

void expect_integrals(const Shape& shape, const Eigen::Vector4d& integrals) {
  const double v = volume(shape);
  EXPECT_NEAR(v / integrals[0], 1.0, 2e-3);
  const Vector3d moments = central_inertia(shape, 3.0).diagonal() / 3.0 * v;
  const Vector3d expected(integrals[2] + integrals[3], integrals[1] + integrals[3],
                          integrals[1] + integrals[2]);
  EXPECT_LE((moments - expected).norm() / expected.norm(), 2e-3);
}

TEST(Shape, CylinderIntegrals) {
  expect_integrals(Cylinder{1.5, 4.0}, integrate({1.5, 1.5, 2.0}, [](const Vector3d& p) {
                     return p.head<2>().norm() <= 1.5;
                   }));
}

TEST(Shape, BoxIntegrals) {
  expect_integrals(Box{{1, 2, 3}}, integrate({0.5, 1, 1.5}, [](const Vector3d&) { return true; }));
}

TEST(Shape, EllipsoidIntegrals) {
  const Vector3d radii(1, 2, 3);
  expect_integrals(Ellipsoid{radii}, integrate(radii, [&](const Vector3d& p) {
                     return p.cwiseQuotient(radii).norm() <= 1;
                   }));
}

TEST(Shape, KnownVolumes) {
  EXPECT_DOUBLE_EQ(volume(Cylinder{1, 8}), 8 * pi);
  EXPECT_DOUBLE_EQ(volume(Box{{1, 2, 3}}), 6);
  EXPECT_DOUBLE_EQ(volume(Ellipsoid{{1, 1, 1}}), 4 * pi / 3);
}

TEST(Shape, BoundingRadiusReachesTheFarthestPoint) {
  EXPECT_DOUBLE_EQ(bounding_radius(Cylinder{3, 8}), 5);
  EXPECT_DOUBLE_EQ(bounding_radius(Box{{2, 4, 4}}), 3);
  EXPECT_DOUBLE_EQ(bounding_radius(Ellipsoid{{1, 5, 2}}), 5);
}

TEST(Shape, FrameHasItsThirdAxisWhereAsked) {
  std::mt19937_64 generator(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Vector3d axis(normal(generator), normal(generator), normal(generator));
    const Eigen::Matrix3d frame = frame_with_z_along(axis);
    EXPECT_LE((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_GT(frame.determinant(), 0);
    EXPECT_LE((frame.col(2) - axis.normalized()).norm(), 1e-15);
  }
}

TEST(Shape, OnlyTheDirectionOfTheAxisMatters) {
  const Vector3d axis(1, -2, 3);
  const Eigen::Matrix3d frame = frame_with_z_along(axis);
  for (const int power : {-1000, -600, 600, 1020}) {
    EXPECT_LE((frame_with_z_along(std::ldexp(1.0, power) * axis) - frame).norm(), 1e-15) << power;
  }
  EXPECT_EQ(frame_with_z_along({1e-300, 0, 0}), frame_with_z_along({1, 0, 0}));
}

TEST(Shape, FramesOfTheCoordinateAxesAreExact) {
  for (int i = 0; i < 6; ++i) {
    const Vector3d axis = (i < 3 ? 2.0 : -2.0) * Vector3d::Unit(i % 3);
    const Eigen::Matrix3d frame = frame_with_z_along(axis);
    EXPECT_EQ(Eigen::Matrix3d(frame.transpose() * frame), Eigen::Matrix3d::Identity());
  }
}

}  // namespace
}  // namespace twrench::body
