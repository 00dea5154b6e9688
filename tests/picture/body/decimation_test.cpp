#include "picture/body/decimation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "picture/body/half_edges.h"
#include "picture/body/meshes.h"
#include "picture/body/triangle_surface.h"

namespace twrench::picture {
namespace {

Mesh given(body::TriangleMesh triangles, double tolerance) {
  return part_mesh(part_of(std::move(triangles)), tolerance);
}

void expect_closed(const Mesh& mesh) {
  for (const std::uint32_t other : opposite_half_edges(mesh.indices, mesh.vertices.size())) {
    ASSERT_NE(other, no_half_edge);
  }
}

TEST(Decimation, LeavesAsManyTrianglesAsTheToleranceAsksFor) {
  constexpr float radius = 3;
  const Mesh whole = given(ball_of_triangles(radius, 100), 0);
  EXPECT_EQ(whole.indices.size(), 3U * 4 * 99 * 100);
  std::size_t before = whole.indices.size();
  for (const float tolerance : {1e-3F, 4e-3F}) {
    const Mesh mesh = given(ball_of_triangles(radius, 100), tolerance);
    EXPECT_LT(mesh.indices.size(), before / 2);
    before = mesh.indices.size();
    expect_closed(mesh);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const auto place = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].position; };
      // In the middle of a triangle, the deviation may exceed that at the removed vertices.
      ASSERT_GT(glm::length(place(0) + place(1) + place(2)) / 3, radius - 3 * tolerance);
    }
  }
}

TEST(Decimation, KeepsCreasesAndTheirCorners) {
  body::TriangleMesh fine = box_of_triangles({2, 3, 4});
  for (int turn = 0; turn < 4; ++turn) {
    const auto triangles = std::exchange(fine.triangles, {});
    for (const auto& [a, b, c] : triangles) {
      const auto first = static_cast<std::uint32_t>(fine.vertices.size());
      fine.vertices.emplace_back((fine.vertices[a] + fine.vertices[b]) / 2);
      fine.vertices.emplace_back((fine.vertices[b] + fine.vertices[c]) / 2);
      fine.vertices.emplace_back((fine.vertices[c] + fine.vertices[a]) / 2);
      fine.triangles.push_back({a, first, first + 2});
      fine.triangles.push_back({first, b, first + 1});
      fine.triangles.push_back({first + 2, first + 1, c});
      fine.triangles.push_back({first, first + 1, first + 2});
    }
  }
  const Mesh mesh = given(fine, 0.01);
  EXPECT_LT(mesh.indices.size(), fine.triangles.size());  // a third of all triangles
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto place = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]].position; };
    volume += glm::dot(place(0), glm::cross(place(1), place(2))) / 6;
  }
  EXPECT_NEAR(volume, 24, 1e-4);
}

TEST(Decimation, KeepsTheColoursThatOneSees) {
  const auto striped = [](float contrast) {
    body::TriangleMesh ball = ball_of_triangles(1, 60);
    for (const Eigen::Vector3d& vertex : ball.vertices) {
      const bool is_light = std::sin(60 * vertex.z()) > 0;
      ball.colors.push_back({0.5F + (is_light ? contrast : 0), 0.5F, 0.5F});
    }
    return given(ball, 5e-3).indices.size();
  };
  EXPECT_GT(2 * striped(0.4F), 3 * striped(0));
}

}  // namespace
}  // namespace twrench::picture
