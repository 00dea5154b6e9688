#pragma once

#include <twrench/body/triangle_mesh.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace twrench::body {

// The same bodies as in mesh_reference.py, to the last bit.

/// Knuth's linear congruential generator for 64 bits.
class SampleRandom {
 public:
  explicit SampleRandom(std::uint64_t seed) : state_(seed) {}

  double uniform() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

inline TriangleMesh tetrahedron(std::uint64_t seed, double flatness) {
  SampleRandom random(seed);
  TriangleMesh mesh;
  for (int i = 0; i < 4; ++i) {
    const double x = random.uniform() - 0.5, y = random.uniform() - 0.5, z = random.uniform() - 0.5;
    mesh.vertices.emplace_back(x, y, (x + y) / 2 + z * flatness);
  }
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = mesh.vertices[1U + static_cast<unsigned>(i)];
  edges.colwise() -= mesh.vertices[0];
  // Seen from outside, the first triangle is counter-clockwise and the fourth corner is behind it.
  if (edges.col(0).cross(edges.col(1)).dot(edges.col(2)) > 0) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

/// Returns a cube's surface as a grid of n x n squares per side. `point` maps a place in the grid
/// to a vertex.
inline TriangleMesh cube_grid(
    std::uint32_t n,
    const std::function<Eigen::Vector3d(const std::array<std::uint32_t, 3>&)>& point) {
  TriangleMesh mesh;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> index;
  const auto index_of = [&](const std::array<std::uint32_t, 3>& place) {
    const auto [at, is_new] = index.try_emplace(place, static_cast<std::uint32_t>(index.size()));
    if (is_new) mesh.vertices.push_back(point(place));
    return at->second;
  };
  for (std::uint32_t side = 0; side < 6; ++side) {
    const std::uint32_t axis = side / 2, end = side % 2;
    for (std::uint32_t cell = 0; cell < n * n; ++cell) {
      std::array<std::uint32_t, 4> corners{};
      for (std::uint32_t k = 0; k < 4; ++k) {
        std::array<std::uint32_t, 3> place{};
        place[axis] = n * end;
        place[(axis + 1) % 3] = cell / n + (k == 1 || k == 2 ? 1 : 0);
        place[(axis + 2) % 3] = cell % n + (k >= 2 ? 1 : 0);
        corners[k] = index_of(place);
      }
      if (end == 0) corners = {corners[3], corners[2], corners[1], corners[0]};
      mesh.triangles.push_back({corners[0], corners[1], corners[2]});
      mesh.triangles.push_back({corners[0], corners[2], corners[3]});
    }
  }
  return mesh;
}

/// Returns the cube from -1 to 1 with each point moved along its radius.
inline TriangleMesh lumpy_cube(std::uint32_t n) {
  return cube_grid(n, [n](const std::array<std::uint32_t, 3>& place) {
    const auto [i, j, k] = place;
    const double stretch = 1 + SampleRandom((i * 1009ULL + j) * 1009ULL + k).uniform() / 8;
    const auto coordinate = [&](std::uint32_t c) { return (2.0 * c / n - 1) * stretch; };
    return Eigen::Vector3d(coordinate(i), coordinate(j), coordinate(k));
  });
}

/// Returns a body with a cavity of the same shape, so that only a thin layer remains.
inline TriangleMesh hollow(TriangleMesh mesh, double thinness) {
  const std::size_t points = mesh.vertices.size(), faces = mesh.triangles.size();
  for (std::size_t i = 0; i < points; ++i) {
    mesh.vertices.emplace_back(mesh.vertices[i] * (1 - thinness));
  }
  for (std::size_t i = 0; i < faces; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    const auto n = static_cast<std::uint32_t>(points);
    mesh.triangles.push_back({a + n, c + n, b + n});
  }
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex += shift;
  return mesh;
}

inline TriangleMesh toutatis() {
  TriangleMesh mesh;
  std::ifstream file(TWRENCH_TESTS_DIR "/../assets/meshes/toutatis.obj");
  for (std::string word; file >> word;) {
    if (word == "v") {
      Eigen::Vector3d& v = mesh.vertices.emplace_back();
      file >> v.x() >> v.y() >> v.z();
    } else if (word == "f") {
      auto& triangle = mesh.triangles.emplace_back();
      for (std::uint32_t& corner : triangle) file >> corner, --corner;
    } else {
      std::getline(file, word);
    }
  }
  return mesh;
}

}  // namespace twrench::body
