#include "picture/body/triangle_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "picture/body/decimation.h"
#include "picture/body/half_edges.h"
#include "picture/look/material.h"
#include "picture/space/glm_from_eigen.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Triangles between places, three indices each.
struct Triangles {
  std::vector<Vector3d> places;
  std::vector<std::uint32_t> corners;

  std::size_t count() const { return corners.size() / 3; }
  const Vector3d& place(std::size_t corner) const { return places[corners[corner]]; }
  /// The normal of a triangle; twice its area is the length.
  Vector3d normal(std::size_t triangle) const {
    const Vector3d& a = place(3 * triangle);
    return (place(3 * triangle + 1) - a).cross(place(3 * triangle + 2) - a);
  }
};

/// Returns for each vertex the first one with the same place and colour.
std::vector<std::uint32_t> joined_vertices(const body::TriangleMesh& mesh) {
  const auto key = [&](std::uint32_t i) {
    const Vector3d& v = mesh.vertices[i];
    const auto color = mesh.colors.empty() ? std::array<float, 3>{} : mesh.colors[i];
    return std::tuple(v.x(), v.y(), v.z(), color);
  };
  return first_equal(mesh.vertices.size(),
                     [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
}

/// Whether a triangle has no width: its normal is then round-off.
bool is_degenerate(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  constexpr double round_off = 1e-12;
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() <= round_off * longest;
}

Triangles placed(const body::TriangleMesh& mesh, const Vector3d& position,
                 const Matrix3d& body_from_part) {
  Triangles result;
  result.places.reserve(mesh.vertices.size());
  for (const Vector3d& v : mesh.vertices) {
    result.places.emplace_back(position + body_from_part * v);
  }
  const std::vector<std::uint32_t> first = joined_vertices(mesh);
  result.corners.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    if (is_degenerate(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c])) continue;
    result.corners.insert(result.corners.end(), {first[a], first[b], first[c]});
  }
  return result;
}

/// Spreads the bits of a number below 1024, with two zero bits between them.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16U)) & 0x030000FFU;
  x = (x | (x << 8U)) & 0x0300F00FU;
  x = (x | (x << 4U)) & 0x030C30C3U;
  return (x | (x << 2U)) & 0x09249249U;
}

/// Sorts triangles along Morton's curve. Consecutive triangles are then close together: vertices
/// are shaded once, and clusters are compact.
void sort_by_place(Triangles& triangles) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i) box.extend(triangles.place(i));
  const double cell = box.sizes().maxCoeff() / 1023;
  std::vector<std::pair<std::uint32_t, std::array<std::uint32_t, 3>>> keyed;
  keyed.reserve(triangles.count());
  for (std::size_t i = 0; i < triangles.corners.size(); i += 3) {
    const Vector3d middle =
        (triangles.place(i) + triangles.place(i + 1) + triangles.place(i + 2)) / 3;
    const Eigen::Array3i at = ((middle - box.min()) / cell).array().cast<int>();
    std::uint32_t key = 0;
    for (const int axis : {0, 1, 2}) key |= spread(static_cast<std::uint32_t>(at[axis])) << axis;
    keyed.emplace_back(
        key, std::array{triangles.corners[i], triangles.corners[i + 1], triangles.corners[i + 2]});
  }
  std::ranges::stable_sort(keyed, {}, [](const auto& each) { return each.first; });
  auto out = triangles.corners.begin();
  for (const auto& [key, corners] : keyed) out = std::ranges::copy(corners, out).out;
}

/// Disjoint sets of corners (Tarjan's, with path halving).
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }

  /// Returns the lowest corner of the set.
  std::uint32_t find(std::uint32_t corner) {
    while (parents_[corner] != corner) {
      parents_[corner] = parents_[parents_[corner]];
      corner = parents_[corner];
    }
    return corner;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parents_[high] = low;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

/// Returns sets of corners in one place between whose triangles the surface is smooth.
CornerSets smooth_corners(const Triangles& triangles, const std::vector<Vector3d>& normals,
                          double crease_angle) {
  const std::vector<std::uint32_t> opposite =
      opposite_half_edges(triangles.corners, triangles.places.size());
  const double least_cosine = std::cos(crease_angle);
  CornerSets sets(triangles.corners.size());
  for (std::uint32_t i = 0; i < opposite.size(); ++i) {
    const std::uint32_t other = opposite[i];
    if (other == no_half_edge || other > i) continue;
    if (normals[i / 3].dot(normals[other / 3]) < least_cosine) continue;
    sets.join(i, next_half_edge(other));
    sets.join(next_half_edge(i), other);
  }
  return sets;
}

/// The angle of a triangle at a corner.
double angle_at(const Triangles& triangles, std::uint32_t corner) {
  const std::uint32_t next = next_half_edge(corner);
  const Vector3d& place = triangles.place(corner);
  const Vector3d one = triangles.place(next) - place;
  const Vector3d other = triangles.place(next_half_edge(next)) - place;
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

std::vector<glm::vec3> linear_colors(const body::TriangleMesh& mesh) {
  std::vector<glm::vec3> result;
  result.reserve(mesh.colors.size());
  for (const auto& srgb : mesh.colors) {
    const auto channel = [&](std::size_t i) {
      return static_cast<float>(linear_from_srgb(255.0 * srgb[i]));
    };
    result.emplace_back(channel(0), channel(1), channel(2));
  }
  return result;
}

/// Creates a vertex for each set of smooth corners.
Mesh with_normals(const Triangles& triangles, double crease_angle,
                  const std::vector<glm::vec3>& colors) {
  std::vector<Vector3d> normals;
  normals.reserve(triangles.count());
  for (std::size_t i = 0; i < triangles.count(); ++i) {
    normals.push_back(triangles.normal(i).stableNormalized());
  }
  CornerSets sets = smooth_corners(triangles, normals, crease_angle);
  const auto count = static_cast<std::uint32_t>(triangles.corners.size());
  std::vector<std::uint32_t> vertex_of(count);
  std::vector<Vector3d> sums;
  Mesh mesh;
  mesh.indices.reserve(count);
  for (std::uint32_t corner = 0; corner < count; ++corner) {
    const std::uint32_t set = sets.find(corner);
    if (set == corner) {
      vertex_of[corner] = static_cast<std::uint32_t>(sums.size());
      sums.emplace_back(Vector3d::Zero());
      mesh.vertices.push_back({glm_from_eigen(triangles.place(corner)), {}});
      if (!colors.empty()) mesh.colors.push_back(colors[triangles.corners[corner]]);
    }
    mesh.indices.push_back(vertex_of[set]);
    sums[vertex_of[set]] += angle_at(triangles, corner) * normals[corner / 3];
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    mesh.vertices[i].normal = glm_from_eigen(sums[i].normalized().eval());
  }
  return mesh;
}

/// Adds the same triangles turned over.
void add_other_side(Mesh& mesh) {
  const std::size_t vertices = mesh.vertices.size(), indices = mesh.indices.size();
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto [position, normal] = mesh.vertices[i];
    mesh.vertices.push_back({position, -normal});
  }
  for (std::size_t i = 0; i < vertices && !mesh.colors.empty(); ++i) {
    mesh.colors.push_back(mesh.colors[i]);
  }
  const auto turned = [&](std::size_t i) {
    return static_cast<std::uint32_t>(mesh.indices[i] + vertices);
  };
  for (std::size_t i = 0; i < indices; i += 3) {
    const std::array corners{turned(i), turned(i + 2), turned(i + 1)};
    mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
  }
}

std::vector<Cluster> clusters_of(const Mesh& mesh) {
  constexpr std::size_t most = std::size_t{3} * 128;
  std::vector<Cluster> clusters;
  for (std::size_t begin = 0; begin < mesh.indices.size(); begin += most) {
    const std::size_t end = std::min(begin + most, mesh.indices.size());
    glm::vec3 sum(0);
    for (std::size_t i = begin; i < end; ++i) sum += mesh.vertices[mesh.indices[i]].position;
    clusters.push_back({begin, end, sum / static_cast<float>(end - begin)});
  }
  return clusters;
}

}  // namespace

Mesh triangle_surface(const body::Mesh& mesh, const Vector3d& position,
                      const Matrix3d& body_from_part, double tolerance, double crease_angle) {
  Triangles triangles = placed(*mesh.surface, position, body_from_part);
  sort_by_place(triangles);
  Mesh result = with_normals(triangles, crease_angle, linear_colors(*mesh.surface));
  decimate(result, tolerance);
  if (mesh.shell > 0) add_other_side(result);
  result.vertex_ends = {result.vertices.size()};
  result.part_ends = {result.indices.size()};
  result.sides.resize(1);
  result.is_colored = {static_cast<char>(result.colors.empty() ? 0 : 1)};
  result.clusters = {clusters_of(result)};
  return result;
}

}  // namespace twrench::picture
