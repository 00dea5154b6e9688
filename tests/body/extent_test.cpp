#include <gtest/gtest.h>
#include <twrench/body/shape.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace twrench::body {
namespace {

using Eigen::Vector3d;

std::vector<Shape> shapes() {
  return {Cylinder{1, 3},
          Box{{2, 3, 4}},
          Ellipsoid{{1, 2, 3}},
          Cone{2, 5},
          Cone{1, 3, 2},
          Torus{3, 1},
          Capsule{1, 4},
          Tube{2, 1, 3},
          make_mesh({{{-1, -2, -1}, {3, -1, -1}, {0, 3, -1}, {0, 0, 4}},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                     {}})};
}

/// Returns directions spread evenly over the sphere.
std::vector<Vector3d> directions() {
  std::vector<Vector3d> result;
  for (int i = 0; i < 2000; ++i) {
    const double z = 1 - (2 * i + 1) / 2000.0;
    const double across = std::sqrt(1 - z * z);
    result.emplace_back(across * std::cos(2.4 * i), across * std::sin(2.4 * i), z);
  }
  return result;
}

// The support points of all directions lie on the convex hull. In any direction, none may be
// farther than that direction's own support point.
TEST(Support, IsFarthestInItsDirection) {
  for (const Shape& shape : shapes()) {
    std::vector<Vector3d> points;
    for (const Vector3d& d : directions()) points.push_back(support(shape, 7 * d));
    for (const Vector3d& d : directions()) {
      const double farthest = d.dot(support(shape, d));
      for (std::size_t i = 0; i < points.size(); i += 7) {
        ASSERT_LE(d.dot(points[i]), farthest + 1e-12) << shape.index();
      }
    }
  }
}

TEST(Support, IsWhatTheShapesMeasuresSay) {
  EXPECT_NEAR((support(Cylinder{1, 3}, {0, 2, -1}) - Vector3d(0, 1, -1.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((support(Cone{2, 5}, {1, 0, 10}) - Vector3d(0, 0, 2.5)).norm(), 0, 1e-12)
      << "its tip";
  EXPECT_NEAR((support(Cone{2, 5}, {1, 0, 0}) - Vector3d(2, 0, -2.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((support(Torus{3, 1}, {-1, 0, 0}) - Vector3d(-4, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((support(Torus{3, 1}, {3, 0, 4}) - Vector3d(3.6, 0, 0.8)).norm(), 0, 1e-12);
  EXPECT_NEAR((support(Capsule{1, 4}, {0, 0, 1}) - Vector3d(0, 0, 3)).norm(), 0, 1e-12);
}

TEST(BoundingBox, IsThatOfTheSupports) {
  const Eigen::AlignedBox3d cone = bounding_box(Cone{1, 3, 2});
  EXPECT_NEAR((cone.max() - Vector3d(2, 2, 1.5)).norm(), 0, 1e-12);
  EXPECT_NEAR((cone.min() + Vector3d(2, 2, 1.5)).norm(), 0, 1e-12);
  const Eigen::AlignedBox3d mesh = bounding_box(shapes().back());
  EXPECT_NEAR((mesh.min() - Vector3d(-1, -2, -1)).norm(), 0, 1e-12);
  EXPECT_NEAR((mesh.max() - Vector3d(3, 3, 4)).norm(), 0, 1e-12);
}

TEST(BoundingRadius, ReachesToTheFarSideFromAnyCentre) {
  for (const Shape& shape : shapes()) {
    for (const Vector3d& centre : {Vector3d(0, 0, 0), Vector3d(2, -1, 5), Vector3d(0, 0, -7)}) {
      double farthest = 0;
      for (const Vector3d& d : directions()) {
        farthest = std::max(farthest, (support(shape, d) - centre).norm());
      }
      const double radius = bounding_radius(shape, centre);
      EXPECT_GE(radius, farthest - 1e-9) << shape.index();
      const bool is_bound = std::holds_alternative<Ellipsoid>(shape) && !centre.isZero();
      EXPECT_LE(radius, farthest * (is_bound ? 1.3 : 1.01)) << shape.index();
    }
  }
}

}  // namespace
}  // namespace twrench::body
