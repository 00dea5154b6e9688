#include "picture/body/intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "picture/body/body_model.h"
#include "picture/body/meshes.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

PartIntersections intersections_of(const std::vector<body::Part>& parts) {
  const Mesh mesh = body_mesh(parts, 1e-3);
  return find_intersections(mesh, part_models(parts, mesh, 5));
}

body::Part at(body::Part part, const Vector3d& position) {
  part.position = position;
  return part;
}

glm::vec3 along(const IntersectionEdge& edge) {
  return edge.ends[1].position - edge.ends[0].position;
}

float length_of(const std::vector<IntersectionEdge>& edges) {
  float sum = 0;
  for (const IntersectionEdge& edge : edges) sum += glm::length(along(edge));
  return sum;
}

// The face z = 0.6 of a box cuts a ball of radius 1 in a circle of radius 0.8.
TEST(Intersections, OfABallWithAFaceAreACircle) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const body::Part ball = part_of(ball_of_triangles(scale, 60));
    const body::Part box =
        at(part_of(box_of_triangles(scale * Vector3d(4, 4, 2))), {0, 0, -0.4 * scale});
    const std::vector<body::Part> parts{ball, box};
    const Mesh mesh = body_mesh(parts, 0);
    const PartIntersections found = find_intersections(mesh, part_models(parts, mesh, scale));
    const auto unit = static_cast<float>(scale);
    for (const std::size_t part : {0U, 1U}) {
      EXPECT_NEAR(length_of(found[part]) / unit, 2 * std::numbers::pi * 0.8, 0.01) << scale;
      for (const IntersectionEdge& edge : found[part]) {
        for (const auto& [position, normal] : edge.ends) {
          EXPECT_NEAR(position.z / unit, 0.6F, 1e-4F);
          EXPECT_NEAR(std::hypot(position.x, position.y) / unit, 0.8F, 2e-3F);
          const glm::vec3 outward = part == 0 ? position / unit : glm::vec3(0, 0, 1);
          EXPECT_GT(glm::dot(normal, outward), 0.99F);
        }
      }
    }
  }
}

// The side to the left of an edge, as seen from outside, is not inside the other part.
TEST(Intersections, HaveTheVisibleSideOnTheLeft) {
  const auto found = intersections_of(
      {part_of(ball_of_triangles(1, 60)), at(part_of(box_of_triangles({4, 4, 2})), {0, 0, -0.4})});
  for (const IntersectionEdge& edge : found[0]) {
    const glm::vec3 left = glm::cross(edge.ends[0].normal, along(edge));
    EXPECT_GT(left.z, 0) << "the cap of the ball is above the box";
  }
  for (const IntersectionEdge& edge : found[1]) {
    const glm::vec3 left = glm::cross(edge.ends[0].normal, along(edge));
    EXPECT_GT(glm::dot(left, edge.ends[0].position), 0) << "the face of the box is around the ball";
  }
}

// The curve is closed: each edge ends where another one of the same part begins.
TEST(Intersections, AreClosedCurves) {
  const auto found = intersections_of(
      {part_of(ball_of_triangles(1, 20)), at(part_of(ball_of_triangles(1, 17)), {0.7, 0.2, 0.3})});
  for (const auto& edges : found) {
    ASSERT_GT(edges.size(), 40U);
    for (const IntersectionEdge& edge : edges) {
      const bool is_continued = std::ranges::any_of(edges, [&](const IntersectionEdge& next) {
        return glm::distance(edge.ends[1].position, next.ends[0].position) < 1e-5F;
      });
      EXPECT_TRUE(is_continued);
    }
  }
}

TEST(Intersections, HaveTheColoursOfTheSurface) {
  body::TriangleMesh ball = ball_of_triangles(1, 60);
  for (const Vector3d& vertex : ball.vertices) {
    ball.colors.push_back(vertex.x() < 0 ? std::array{0.0F, 0.0F, 0.0F}
                                         : std::array{1.0F, 1.0F, 1.0F});
  }
  const auto found =
      intersections_of({part_of(ball), at(part_of(box_of_triangles({4, 4, 2})), {0, 0, -0.4})});
  for (const IntersectionEdge& edge : found[0]) {
    const float x = edge.ends[0].position.x;
    if (std::abs(x) > 0.2F) {
      EXPECT_NEAR(edge.colors[0].r, x < 0 ? 0 : 1, 1e-5F);
    }
  }
}

TEST(Intersections, AreNoneBetweenPartsThatDoNotMeet) {
  const body::Part ball = part_of(ball_of_triangles(1, 20));
  const body::Part box = part_of(box_of_triangles({1, 1, 1}));
  for (const auto& parts : {std::vector{ball, at(ball, {3, 0, 0})},
                            std::vector{ball, part_of(ball_of_triangles(0.5, 20))},
                            std::vector{box, at(box, {0, 0, 1})}}) {
    for (const auto& edges : intersections_of(parts)) EXPECT_TRUE(edges.empty());
  }
}

// The shader fades out the leg of the T-wrench over its handle.
TEST(Intersections, AreLeftToTheShaderOverALongCylinder) {
  const auto wrench = intersections_of(
      {cylinder(1, 8, {0, 0, 0}, Vector3d::UnitY()), cylinder(1, 4, {2, 0, 0}, Vector3d::UnitX())});
  for (const auto& edges : wrench) EXPECT_TRUE(edges.empty());
  const auto disc = intersections_of({cylinder(1, 0.2, {0, 0, 0}, Vector3d::UnitZ()),
                                      cylinder(0.5, 0.2, {0, 0, 0.1}, Vector3d::UnitZ())});
  EXPECT_NEAR(length_of(disc[0]), std::numbers::pi, 0.02) << "a disc is no long cylinder";
}

}  // namespace
}  // namespace twrench::picture
