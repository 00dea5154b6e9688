#pragma once

#include <twrench/body/shape.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace twrench::picture {

/// A box of 12 triangles about the origin.
inline body::TriangleMesh box_of_triangles(const Eigen::Vector3d& size) {
  body::TriangleMesh mesh;
  for (const unsigned i : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U}) {
    const Eigen::Vector3d corner((i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5,
                                 (i & 4U) != 0 ? 0.5 : -0.5);
    mesh.vertices.emplace_back(corner.cwiseProduct(size));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A ball of 4 (n - 1) n triangles.
inline body::TriangleMesh ball_of_triangles(double radius, std::uint32_t n) {
  const std::uint32_t around = 2 * n;
  body::TriangleMesh mesh;
  mesh.vertices = {{0, 0, radius}, {0, 0, -radius}};
  const auto vertex = [&](std::uint32_t ring, std::uint32_t i) -> std::uint32_t {
    if (ring == 0 || ring == n) return ring == 0 ? 0 : 1;
    return 2 + (ring - 1) * around + i % around;
  };
  for (std::uint32_t ring = 1; ring < n; ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double polar = std::numbers::pi * ring / n, azimuth = std::numbers::pi * i / n;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(azimuth),
                                 radius * std::sin(polar) * std::sin(azimuth),
                                 radius * std::cos(polar));
    }
  }
  for (std::uint32_t ring = 0; ring < n; ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = vertex(ring, i), b = vertex(ring + 1, i), c = vertex(ring + 1, i + 1),
                          d = vertex(ring, i + 1);
      if (ring > 0) mesh.triangles.push_back({a, c, d});
      if (ring + 1 < n) mesh.triangles.push_back({a, b, c});
    }
  }
  return mesh;
}

/// A part at the origin.
inline body::Part part_of(body::TriangleMesh mesh, double shell = 0) {
  return {body::make_mesh(std::move(mesh), shell), 1, {0, 0, 0}, Eigen::Matrix3d::Identity()};
}

}  // namespace twrench::picture
