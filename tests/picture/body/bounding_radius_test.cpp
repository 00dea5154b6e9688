#include "picture/body/bounding_radius.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "picture/body/mesh.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

TEST(Reach, OfTheTWrenchIsToTheRimOfTheHandle) {
  EXPECT_NEAR(bounding_radius(t_wrench().body.parts), std::hypot(2, 4), 1e-12);
}

TEST(Reach, OfASphereIsItsFarSide) {
  const std::vector<body::Part> ball{
      {body::Ellipsoid{{2, 2, 2}}, 1.0, {3, 0, 4}, Eigen::Matrix3d::Identity()}};
  EXPECT_NEAR(bounding_radius(ball), 7, 1e-12);
}

TEST(Reach, HoldsTheMeshOfAnyPartClosely) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(3, -1, 2).normalized()).toRotationMatrix();
  for (const body::Shape& shape :
       {body::Shape{body::Cylinder{1, 3}}, body::Shape{body::Box{{2, 3, 4}}}}) {
    const std::vector<body::Part> parts{{shape, 1.0, {1, -2, 0.5}, turn}};
    double farthest = 0;
    for (const Vertex& vertex : body_mesh(parts, 1e-3).vertices) {
      const Eigen::Vector3d p(vertex.position.x, vertex.position.y, vertex.position.z);
      farthest = std::max(farthest, p.norm());
    }
    EXPECT_GE(bounding_radius(parts), farthest);
    EXPECT_LT(bounding_radius(parts), farthest + 0.05);  // except for the bevel
  }
}

}  // namespace
}  // namespace twrench::picture
