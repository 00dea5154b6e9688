#pragma once

#include <fmt/format.h>
#include <twrench/body/triangle_mesh.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

namespace twrench::mesh {

/// Returns the cube from 0 to 1 as six quadrilaterals.
inline std::string cube_obj() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

/// Returns a cube with its least corner at `at`, as twelve triangles.
inline body::TriangleMesh cube(const Eigen::Vector3d& at, double size) {
  body::TriangleMesh mesh;
  for (const auto& [x, y, z] : std::to_array<std::array<double, 3>>({{0, 0, 0},
                                                                     {1, 0, 0},
                                                                     {1, 1, 0},
                                                                     {0, 1, 0},
                                                                     {0, 0, 1},
                                                                     {1, 0, 1},
                                                                     {1, 1, 1},
                                                                     {0, 1, 1}})) {
    mesh.vertices.emplace_back(at + size * Eigen::Vector3d(x, y, z));
  }
  for (const auto& [a, b, c, d] : std::to_array<std::array<std::uint32_t, 4>>(
           {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

inline body::TriangleMesh joined(body::TriangleMesh mesh, const body::TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
  return mesh;
}

inline body::TriangleMesh turned(body::TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

inline body::TriangleMesh moved(body::TriangleMesh mesh, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex += shift;
  return mesh;
}

/// Returns the unit ball as a grid of longitudes and latitudes. At a pole, each triangle has a
/// separate vertex, `gap` from the next one.
inline body::TriangleMesh ball_with_open_poles(std::uint32_t longitudes, std::uint32_t bands,
                                               double gap) {
  using std::numbers::pi;
  body::TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= bands; ++j) {
    for (std::uint32_t i = 0; i < longitudes; ++i) {
      const double polar = pi * j / bands, around = 2 * pi * i / longitudes;
      const bool is_pole = j == 0 || j == bands;
      const double radius = is_pole ? gap * longitudes / (2 * pi) : std::sin(polar);
      mesh.vertices.emplace_back(radius * std::cos(around), radius * std::sin(around),
                                 j == bands ? -1.0 : std::cos(polar));
    }
  }
  for (std::uint32_t j = 0; j < bands; ++j) {
    for (std::uint32_t i = 0; i < longitudes; ++i) {
      const std::uint32_t next = (i + 1) % longitudes, upper = j * longitudes,
                          lower = upper + longitudes;
      if (j + 1 < bands) mesh.triangles.push_back({upper + i, lower + i, lower + next});
      if (j + 1 == bands) mesh.triangles.push_back({upper + i, lower + i, upper + next});
      if (j > 0 && j + 1 < bands) mesh.triangles.push_back({upper + i, lower + next, upper + next});
    }
  }
  return mesh;
}

inline std::string obj_of(const body::TriangleMesh& mesh) {
  std::string text;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  }
  return text;
}

/// Appends a number in the given byte order.
template <typename Number>
void append(std::string& bytes, Number number, std::endian order = std::endian::little) {
  auto own = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (std::endian::native != order) std::reverse(own.begin(), own.end());
  bytes.append(own.data(), own.size());
}

inline std::string binary_stl(const body::TriangleMesh& mesh, std::string header = "by a test") {
  header.resize(80, ' ');
  append(header, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(header, 0.0F);
    for (const std::uint32_t corner : triangle) {
      for (const double x : mesh.vertices[corner]) append(header, static_cast<float>(x));
    }
    append(header, std::uint16_t{0});
  }
  return header;
}

inline std::string text_stl(const body::TriangleMesh& mesh) {
  std::string text = "solid cube\n";
  for (const auto& triangle : mesh.triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const std::uint32_t corner : triangle) {
      const Eigen::Vector3d& v = mesh.vertices[corner];
      text += fmt::format("   vertex {} {} {}\n", v.x(), v.y(), v.z());
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid cube\n";
}

}  // namespace twrench::mesh
