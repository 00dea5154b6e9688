#include "interchange/surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace twrench::interchange {
namespace {

using Eigen::Vector3d;

Vector3d vector_at(const std::vector<float>& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

/// The volume in m^3 that the triangles enclose, positive if they face outwards. Each triangle must
/// face in the direction of its normals.
double volume_within(const Surface& surface) {
  double volume = 0;
  for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
    Vector3d corner[3], normal(0, 0, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = vector_at(surface.positions, surface.indices[i + k]);
      const Vector3d n = vector_at(surface.normals, surface.indices[i + k]);
      EXPECT_NEAR(n.norm(), 1, 1e-6);
      normal += n;
    }
    const Vector3d area = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    EXPECT_GT(area.norm(), 0);
    EXPECT_GT(area.dot(normal), 0);
    volume += corner[0].dot(corner[1].cross(corner[2])) / 6;
  }
  return volume;
}

TEST(Surface, OfAPartIsInMetres) {
  const body::Part ball{
      body::Ellipsoid{Vector3d(1, 2, 3)}, 1, {0, 0, 5}, Eigen::Matrix3d::Identity()};
  EXPECT_NEAR(volume_within(part_surface(ball, 1e-3, 0.6)), 8e-6 * std::numbers::pi, 5e-8);
}

TEST(Surface, OfAnArrowIsClosed) {
  const double polygon = 16 * std::sin(2 * std::numbers::pi / 32);  // replaces pi
  const double head = polygon * 2.4 * 2.4 * 5.5 / 3;
  EXPECT_NEAR(volume_within(arrow_surface(10, 1)), 1e-6 * (head + 4.5 * polygon), 1e-10);
  EXPECT_NEAR(volume_within(arrow_surface(2.75, 1)), 1e-6 * head / 8, 1e-10) << "the head alone";
}

}  // namespace
}  // namespace twrench::interchange
