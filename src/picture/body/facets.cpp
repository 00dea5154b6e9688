#include "picture/body/facets.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "picture/body/polygon.h"

namespace twrench::picture {
namespace {

/// The strips of a side, with indices that wrap around it.
class SideFacets {
 public:
  SideFacets(const Mesh& mesh, const CylinderSide& side, const glm::vec3& eye, Facets& facets)
      : mesh_(mesh), side_(side), eye_(eye), facets_(facets) {}

  void add_seen() {
    std::uint32_t first = 0;
    while (first < side_.count && (is_seen(first + side_.count - 1) || !is_seen(first))) ++first;
    if (first == side_.count) return;  // the cylinder is seen end-on
    std::uint32_t end = first;
    while (is_seen(end)) ++end;
    for (std::uint32_t at = first; at < end;) {
      const std::uint32_t from_outline = std::min(at - first, (end - at) / 2);
      const std::uint32_t next = at + std::clamp(from_outline, 1U, side_.most_merged);
      add(at, next);
      at = next;
    }
  }

 private:
  std::uint32_t low(std::uint32_t i) const { return side_.low + i % side_.count; }
  std::uint32_t high(std::uint32_t i) const { return side_.high + i % side_.count; }

  bool is_seen(std::uint32_t strip) const {
    const Vertex& first = mesh_.vertices[low(strip)];
    const Vertex& second = mesh_.vertices[low(strip + 1)];
    return glm::dot(first.normal + second.normal, eye_ - first.position) > 0;
  }

  /// Adds one facet for the strips from `first` to `end`, and the triangles that connect it to the
  /// rings.
  void add(std::uint32_t first, std::uint32_t end) {
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      facets_.indices.insert(facets_.indices.end(), {a, b, c});
    };
    const Vertex& one = mesh_.vertices[low(first)];
    const Vertex& other = mesh_.vertices[low(end)];
    const double radius =
        glm::distance(one.position, other.position) / glm::distance(one.normal, other.normal);
    const double cosine = 0.5 * glm::length(one.normal + other.normal);  // of half the angle
    facets_.depth = std::max(facets_.depth, radius * (1 - cosine));
    triangle(low(first), low(end), high(end));
    triangle(low(first), high(end), high(first));
    fill_polygon(first, end, false, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangle(low(a), low(b), low(c));
    });
    fill_polygon(first, end, true, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      triangle(high(a), high(b), high(c));
    });
  }

  const Mesh& mesh_;
  const CylinderSide& side_;
  const glm::vec3& eye_;
  Facets& facets_;
};

/// Appends the triangles of clusters that face the eye.
void add_clusters(const Mesh& mesh, std::vector<Cluster> clusters, const glm::vec3& eye,
                  std::span<const char> faces_eye, std::vector<std::uint32_t>& indices) {
  std::ranges::sort(clusters, {}, [&](const Cluster& cluster) {
    const glm::vec3 to_eye = eye - cluster.centre;
    return glm::dot(to_eye, to_eye);
  });
  for (const Cluster& cluster : clusters) {
    for (std::size_t i = cluster.begin; i < cluster.end; i += 3) {
      if (faces_eye[i / 3] == 0) continue;
      for (std::size_t k = i; k < i + 3; ++k) indices.push_back(mesh.indices[k]);
    }
  }
}

}  // namespace

Facets visible_facets(const Mesh& mesh, const glm::vec3& eye, std::span<const char> faces_eye) {
  Facets result;
  result.indices.reserve(mesh.indices.size());
  const auto from_mesh = mesh.indices.begin();
  std::ptrdiff_t begin = 0;
  for (std::size_t part = 0; part < mesh.part_ends.size(); ++part) {
    const auto end = static_cast<std::ptrdiff_t>(mesh.part_ends[part]);
    const auto& side = mesh.sides[part];
    const auto& clusters = mesh.clusters[part];
    if (clusters.empty()) {
      result.indices.insert(result.indices.end(), from_mesh + begin,
                            from_mesh + (side ? static_cast<std::ptrdiff_t>(side->begin) : end));
    } else {
      add_clusters(mesh, clusters, eye, faces_eye, result.indices);
    }
    result.side_begins.push_back(result.indices.size());
    if (side) SideFacets(mesh, *side, eye, result).add_seen();
    result.part_ends.push_back(result.indices.size());
    begin = end;
  }
  return result;
}

}  // namespace twrench::picture
