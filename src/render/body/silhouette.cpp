#include "render/body/silhouette.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

namespace twrench::render {
namespace {

/// For each vertex the first one at the same position: corners of boxes have several, one per face.
std::vector<std::uint32_t> first_at_each_place(const std::vector<Vertex>& vertices) {
  std::map<std::tuple<float, float, float>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  result.reserve(vertices.size());
  for (const Vertex& vertex : vertices) {
    const glm::vec3& p = vertex.position;
    const auto number = static_cast<std::uint32_t>(result.size());
    result.push_back(first.emplace(std::tuple(p.x, p.y, p.z), number).first->second);
  }
  return result;
}

}  // namespace

Silhouette::Silhouette(const Mesh& mesh)
    : vertices_(mesh.vertices), first_at_(first_at_each_place(vertices_)) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> half_edges;  // to their triangle
  for (const std::size_t end : mesh.part_ends) {
    for (std::size_t i = 3 * triangles_.size(); i < end; i += 3) {
      const auto triangle = static_cast<std::uint32_t>(triangles_.size());
      const std::array corners{first_at_[mesh.indices[i]], first_at_[mesh.indices[i + 1]],
                               first_at_[mesh.indices[i + 2]]};
      const glm::vec3 a = vertices_[corners[0]].position;
      triangles_.push_back({corners, glm::cross(vertices_[corners[1]].position - a,
                                                vertices_[corners[2]].position - a)});
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = corners[k];
        const std::uint32_t to = corners[(k + 1) % 3];
        if (const auto other = half_edges.find({to, from}); other != half_edges.end()) {
          edges_.push_back({{from, to}, {triangle, other->second}});
          half_edges.erase(other);
        } else {
          half_edges.emplace(std::array{from, to}, triangle);
        }
      }
    }
    edge_ends_.push_back(edges_.size());
  }
  seen_.resize(triangles_.size());
  offsets_.resize(vertices_.size());
  on_it_.resize(vertices_.size());
}

void Silhouette::find(const glm::vec3& eye, float scale) {
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const glm::vec3 to_eye = eye - vertices_[triangles_[i].corners[0]].position;
    seen_[i] = glm::dot(triangles_[i].normal, to_eye) > 0 ? 1 : 0;
  }
  edge_quads_.clear();
  indices_.clear();
  part_ends_.clear();
  offsets_.assign(offsets_.size(), 0);
  on_it_.assign(on_it_.size(), 0);
  std::size_t edge = 0;
  for (const std::size_t end : edge_ends_) {
    for (; edge < end; ++edge) {
      const auto& [one, other] = edges_[edge].triangles;
      if (seen_[one] == seen_[other]) continue;
      add_edge_quad(edges_[edge]);
    }
    part_ends_.push_back(indices_.size());
  }
  shrink(eye, scale);
}

/// The distance of a vertex inside the silhouette is measured on the screen: along the normal,
/// without its component along the line of sight.
void Silhouette::shrink(const glm::vec3& eye, float scale) {
  for (const Triangle& triangle : triangles_) {
    for (const std::uint32_t edge : triangle.corners) {
      if (on_it_[edge] == 0) continue;
      const auto& [place, normal] = vertices_[edge];
      const glm::vec3 sight = glm::normalize(eye - place);
      const glm::vec3 across = glm::normalize(normal - glm::dot(normal, sight) * sight);
      for (const std::uint32_t corner : triangle.corners) {
        const float within = scale * glm::dot(across, place - vertices_[corner].position);
        offsets_[corner] = std::min(offsets_[corner], std::clamp(2 * within - 1, -1.0F, 0.0F));
      }
    }
  }
  for (std::size_t i = 0; i < offsets_.size(); ++i) offsets_[i] = offsets_[first_at_[i]];
}

void Silhouette::add_edge_quad(const Edge& edge) {
  const auto first = static_cast<std::uint32_t>(edge_quads_.size());
  for (const std::uint32_t end : edge.ends) {
    const Vertex& vertex = vertices_[end];
    on_it_[end] = 1;
    edge_quads_.push_back({vertex.position, vertex.normal, -1});
    edge_quads_.push_back({vertex.position, vertex.normal, 1});
  }
  indices_.insert(indices_.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
}

}  // namespace twrench::render
