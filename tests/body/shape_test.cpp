#include <gtest/gtest.h>
#include <twrench/body/shape.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <utility>

#include "body/dimensions.h"
#include "body/sample_meshes.h"

namespace twrench::body {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// Returns the integral of (1, x^2, y^2, z^2) over the shape, by the midpoint rule on a grid.
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

/// The inner and outer radii of a solid of revolution at a height.
using Profile = std::function<std::pair<double, double>(double z)>;

/// Expects the integrals of a solid of revolution between two heights, by the midpoint rule over
/// discs.
void expect_profile(const Shape& shape, double bottom, double top, const Profile& profile) {
  constexpr int n = 200'000;
  const double step = (top - bottom) / n;
  double sum = 0, z_sum = 0, zz_sum = 0, rr_sum = 0;
  for (int i = 0; i < n; ++i) {
    const double z = bottom + (i + 0.5) * step;
    const auto [inner, outer] = profile(z);
    const double area = pi * (outer * outer - inner * inner);
    sum += area * step;
    z_sum += area * z * step;
    zz_sum += area * z * z * step;
    rr_sum += area * (outer * outer + inner * inner) / 4 * step;  // of x^2, and of y^2
  }
  const double mean = z_sum / sum, zz = zz_sum - sum * mean * mean;
  constexpr double round = 1e-7;
  EXPECT_NEAR(volume(shape) / sum, 1, round);
  EXPECT_LE((centroid(shape) - Vector3d(0, 0, mean)).norm(), round * (top - bottom));
  const Eigen::Matrix3d expected = Vector3d(rr_sum + zz, rr_sum + zz, 2 * rr_sum).asDiagonal();
  EXPECT_LE((central_inertia(shape, sum) - expected).norm(), round * expected.norm());
}

TEST(Shape, ConeIntegrals) {
  for (const double top : {0.0, 0.5, 1.5, 4.0}) {
    expect_profile(Cone{1.5, 4, top}, -2, 2,
                   [&](double z) { return std::pair(0.0, 1.5 + (top - 1.5) * (z + 2) / 4); });
  }
}

TEST(Shape, AConeOfOneRadiusIsACylinder) {
  const Shape cone = Cone{1.5, 4, 1.5}, cylinder = Cylinder{1.5, 4};
  EXPECT_DOUBLE_EQ(volume(cone), volume(cylinder));
  EXPECT_LE((central_inertia(cone, 2) - central_inertia(cylinder, 2)).norm(), 1e-14);
  EXPECT_EQ(centroid(cone), Vector3d::Zero());
}

TEST(Shape, TorusIntegrals) {
  for (const double tube : {0.5, 1.9}) {
    expect_profile(Torus{2, tube}, -tube, tube, [&](double z) {
      const double half = std::sqrt(tube * tube - z * z);
      return std::pair(2 - half, 2 + half);
    });
  }
}

TEST(Shape, CapsuleIntegrals) {
  expect_profile(Capsule{0.75, 2}, -1.75, 1.75, [](double z) {
    const double beyond = std::max(std::abs(z) - 1, 0.0);
    return std::pair(0.0, std::sqrt(0.75 * 0.75 - beyond * beyond));
  });
}

TEST(Shape, TubeIntegrals) {
  expect_profile(Tube{1.5, 1.2, 4}, -2, 2, [](double) { return std::pair(1.2, 1.5); });
}

TEST(Shape, IsFoundByItsName) {
  for (const Shape& shape : all_shapes()) {
    const auto found = shape_named(shape_name(shape));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->index(), shape.index());
  }
  EXPECT_FALSE(shape_named("sphere"));
}

TEST(Shape, HasDimensionsThatCanBeSetOneAfterAnother) {
  for (Shape shape : all_shapes()) {
    std::set<std::string> keys;
    std::set<const double*> set;
    for (const Dimension& dimension : dimensions(shape)) {
      EXPECT_TRUE(keys.insert(dimension.key).second) << dimension.key;
      EXPECT_TRUE(dimension.greater == nullptr || set.contains(dimension.greater));
      EXPECT_EQ(dimension.greater != nullptr, keys.contains(dimension.greater_key));
      for (const double& value : dimension.values) EXPECT_TRUE(set.insert(&value).second);
    }
    EXPECT_FALSE(keys.empty()) << shape_name(shape);
  }
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
  EXPECT_DOUBLE_EQ(bounding_radius(Cone{3, 8}), 5);
  EXPECT_DOUBLE_EQ(bounding_radius(Cone{1, 8, 3}), 5);
  EXPECT_DOUBLE_EQ(bounding_radius(Torus{3, 1}), 4);
  EXPECT_DOUBLE_EQ(bounding_radius(Capsule{1, 8}), 5);
  EXPECT_DOUBLE_EQ(bounding_radius(Tube{3, 1, 8}), 5);
  EXPECT_DOUBLE_EQ(bounding_radius(make_mesh(tetrahedron(0, 1.0))),
                   tetrahedron(0, 1.0).vertices[0].norm());
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
