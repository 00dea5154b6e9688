// Compares the shade in hollows with the light that walls of known shape leave.
#include "picture/body/hollows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "picture/body/meshes.h"

namespace twrench::picture {
namespace {

Mesh shaded(body::TriangleMesh triangles, double shell = 0) {
  Mesh mesh = part_mesh(part_of(std::move(triangles), shell), 0);
  shade_hollows(mesh);
  return mesh;
}

/// The light in a hollow whose walls reflect 60 %, from the fraction without reflections.
double with_reflections(double open) {
  return std::max(open, ((open * 0.89184 - 2.23536) * open + 2.34342) * open);
}

/// Appends a rectangle of n by n squares. Seen from outside, `along` is on the left of `across`.
void add_grid(body::TriangleMesh& mesh, const Eigen::Vector3d& corner,
              const Eigen::Vector3d& across, const Eigen::Vector3d& along, unsigned n) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned i = 0; i <= n; ++i) {
    for (unsigned j = 0; j <= n; ++j) {
      mesh.vertices.emplace_back(corner + across * i / n + along * j / n);
    }
  }
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) {
      const std::uint32_t a = first + i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
}

/// A square floor of side 20 in front of a wall of height 2.
body::TriangleMesh floor_and_wall(double unit) {
  body::TriangleMesh mesh;
  add_grid(mesh, {-10 * unit, 0, 0}, {20 * unit, 0, 0}, {0, 20 * unit, 0}, 40);
  add_grid(mesh, {-10 * unit, 0, 0}, {0, 0, 2 * unit}, {20 * unit, 0, 0}, 40);
  return mesh;
}

// At the distance d from a long wall of height h, the wall hides (1 - d / sqrt(d^2 + h^2)) / 2 of
// the cosine-weighted sky.
TEST(Hollows, AreAsDarkAsTheWallBesideThemIsHigh) {
  for (const double unit : {1e-6, 1.0, 1e6}) {
    const Mesh mesh = shaded(floor_and_wall(unit), 0.1 * unit);
    ASSERT_EQ(mesh.is_colored.front(), 1);
    int compared = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const auto& [position, normal] = mesh.vertices[i];
      if (normal.z < 0.99F || position.x != 0 || position.y == 0) continue;
      const double d = position.y / unit;
      const double open = 0.5 + 0.5 * d / std::hypot(d, 2);
      EXPECT_NEAR(mesh.colors[i].x, with_reflections(open), 0.025) << "at " << d << " of " << unit;
      EXPECT_EQ(mesh.colors[i].x, mesh.colors[i].z) << "gray";
      ++compared;
    }
    EXPECT_EQ(compared, 40);
  }
}

TEST(Hollows, AreNotOnAConvexBody) {
  for (const Mesh& mesh : {shaded(ball_of_triangles(2, 20)), shaded(box_of_triangles({3, 2, 1}))}) {
    for (const glm::vec3& color : mesh.colors) EXPECT_EQ(color, glm::vec3(1));
  }
}

TEST(Hollows, AreInsideAWallAndNotOnItsOutside) {
  body::TriangleMesh mesh;  // a square tube that is open at both ends
  const double r = 1, h = 6;
  add_grid(mesh, {-r, -r, -h}, {2 * r, 0, 0}, {0, 0, 2 * h}, 12);
  add_grid(mesh, {r, -r, -h}, {0, 2 * r, 0}, {0, 0, 2 * h}, 12);
  add_grid(mesh, {r, r, -h}, {-2 * r, 0, 0}, {0, 0, 2 * h}, 12);
  add_grid(mesh, {-r, r, -h}, {0, -2 * r, 0}, {0, 0, 2 * h}, 12);
  const Mesh tube = shaded(std::move(mesh), 0.1);
  for (std::size_t i = 0; i < tube.vertices.size(); ++i) {
    const auto& [position, normal] = tube.vertices[i];
    const bool is_outside = glm::dot(position, normal) > 0;
    if (is_outside) {
      EXPECT_EQ(tube.colors[i].x, 1);
    } else if (std::abs(position.z) < 1) {
      EXPECT_LT(tube.colors[i].x, 0.35F);
    }
  }
}

// The cube's corners are hidden in the ball. If they were dark, the visible parts of the cube's
// edges would be dark, too.
TEST(Hollows, AreNotWhereAnotherSurfaceEnclosesAVertex) {
  body::TriangleMesh mesh = ball_of_triangles(2, 30);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& v : box_of_triangles({1, 1, 1}).vertices) mesh.vertices.push_back(v);
  for (const auto& [a, b, c] : box_of_triangles({1, 1, 1}).triangles) {
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
  for (const glm::vec3& color : shaded(std::move(mesh)).colors) EXPECT_EQ(color, glm::vec3(1));
}

TEST(Hollows, DarkenTheColoursOfAMesh) {
  body::TriangleMesh triangles = floor_and_wall(1);
  triangles.colors.assign(triangles.vertices.size(), {1, 0, 0});
  const Mesh mesh = shaded(std::move(triangles), 0.1);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const auto& [position, normal] = mesh.vertices[i];
    EXPECT_EQ(mesh.colors[i].y, 0);
    if (normal.z < 0.99F || position.x != 0 || position.y != 0.5F) continue;
    EXPECT_LT(mesh.colors[i].x, 0.999F);
    EXPECT_GT(mesh.colors[i].x, 0.7F) << "red walls reflect red light";
  }
}

TEST(Hollows, AreOfMeshesOnly) {
  Mesh mesh = part_mesh({body::Tube{1, 0.8, 6}, 1, {0, 0, 0}, Eigen::Matrix3d::Identity()}, 0.01);
  shade_hollows(mesh);
  EXPECT_TRUE(mesh.colors.empty());
}

}  // namespace
}  // namespace twrench::picture
