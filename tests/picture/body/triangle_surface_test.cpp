#include "picture/body/triangle_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "picture/body/half_edges.h"
#include "picture/body/meshes.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double crease_of_35 = 35.0 / 180.0 * std::numbers::pi;

Mesh surface_of(body::TriangleMesh triangles, double crease, double shell = 0,
                const Vector3d& position = Vector3d::Zero()) {
  return triangle_surface(body::make_mesh(std::move(triangles), shell), position,
                          Matrix3d::Identity(), 0, crease);
}

TEST(TriangleSurface, HasCreasesWhereTrianglesMeetAtMoreThanTheCreaseAngle) {
  const Mesh mesh = surface_of(box_of_triangles({2, 3, 4}), crease_of_35);
  EXPECT_EQ(mesh.vertices.size(), 24U);
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec3 n = glm::abs(vertex.normal);
    EXPECT_NEAR(std::max({n.x, n.y, n.z}), 1, 1e-6) << "that of a face";
  }
}

// The result does not depend on how the faces are cut into triangles: each counts by its angle.
TEST(TriangleSurface, IsSmoothWhereTheyMeetAtLess) {
  const Mesh mesh = surface_of(box_of_triangles({2, 2, 2}), 1.6);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::distance(vertex.normal, glm::normalize(vertex.position)), 0, 1e-6);
  }
}

TEST(TriangleSurface, IsFlatWithACreaseAngleOfZero) {
  const Mesh mesh = surface_of(ball_of_triangles(1, 8), 0);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
    const glm::vec3 facet = glm::normalize(glm::cross(corner(1).position - corner(0).position,
                                                      corner(2).position - corner(0).position));
    for (const std::size_t k : {0U, 1U, 2U}) {
      ASSERT_NEAR(glm::distance(corner(k).normal, facet), 0, 1e-5);
    }
  }
}

TEST(TriangleSurface, OfABallHasTheBallsNormals) {
  for (const Vertex& vertex : surface_of(ball_of_triangles(1, 24), crease_of_35).vertices) {
    EXPECT_GT(glm::dot(vertex.normal, vertex.position), 0.9995F);
  }
}

/// Returns the mesh with separate vertices for each triangle, as in an STL file, and with some
/// triangles that have no area.
body::TriangleMesh in_pieces(const body::TriangleMesh& whole) {
  body::TriangleMesh pieces;
  for (const auto& corners : whole.triangles) {
    const auto first = static_cast<std::uint32_t>(pieces.vertices.size());
    for (const std::uint32_t corner : corners) pieces.vertices.push_back(whole.vertices[corner]);
    pieces.triangles.push_back({first, first + 1, first + 2});
    pieces.triangles.push_back({first, first + 1, first});
  }
  return pieces;
}

TEST(TriangleSurface, JoinsVerticesAndLeavesOutTrianglesWithoutArea) {
  const body::TriangleMesh whole = ball_of_triangles(1, 8);
  const Mesh mesh = surface_of(in_pieces(whole), crease_of_35);
  EXPECT_EQ(mesh.vertices.size(), whole.vertices.size());
  EXPECT_EQ(mesh.indices.size(), 3 * whole.triangles.size());
}

TEST(TriangleSurface, FarFromItsOriginIsTheSame) {
  body::TriangleMesh far = ball_of_triangles(1, 8);
  const Vector3d away(2e4, -1e4, 3e4);
  for (Vector3d& vertex : far.vertices) vertex += away;
  const Mesh mesh = surface_of(far, crease_of_35, 0, -away);
  const Mesh near = surface_of(ball_of_triangles(1, 8), crease_of_35);
  ASSERT_EQ(mesh.vertices.size(), near.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(vertex.position), 1, 1e-6);
    EXPECT_GT(glm::dot(vertex.normal, vertex.position), 0.99F);
  }
}

TEST(TriangleSurface, OfAWallHasTwoSidesThatMeetAtItsBorder) {
  const Mesh mesh = surface_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}}, 0.6, 0.1);
  ASSERT_EQ(mesh.indices.size(), 6U);
  EXPECT_EQ(mesh.vertices[mesh.indices[0]].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.vertices[mesh.indices[3]].normal, glm::vec3(0, 0, -1));
}

TEST(TriangleSurface, HasItsVerticesColoursInLinearLight) {
  body::TriangleMesh triangles = ball_of_triangles(1, 8);
  for (const Vector3d& vertex : triangles.vertices) {
    triangles.colors.push_back({vertex.z() > 0 ? 1.0F : 0.5F, 0, 0});
  }
  const Mesh mesh = surface_of(triangles, crease_of_35);
  ASSERT_EQ(mesh.colors.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_NEAR(mesh.colors[i].x, mesh.vertices[i].position.z > 0 ? 1 : 0.2140, 1e-3);
  }
}

}  // namespace
}  // namespace twrench::picture
