#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/body/mesh.h"

namespace twrench::render {

/// A vertex of an edge quad, with members in the order of the vertex shader's attributes.
struct EdgeQuadVertex {
  /// Position on the silhouette in body axes, cm.
  glm::vec3 position;
  /// Unit surface normal there.
  glm::vec3 normal;
  /// Screen-space offset along the normal in half pixels: -1 inside, 1 outside.
  float offset;
};

/// The silhouette of a closed mesh: the edges between a front-facing and a back-facing triangle. It
/// gives antialiased edges at the cost of one sample per pixel: the body is shrunk by half a pixel
/// along its silhouette, and edge quads one pixel wide, whose coverage falls from 1 to 0, are drawn
/// over it (Sander, Hoppe, Snyder and Gortler, "Discontinuity edge overdraw", I3D 2001).
class Silhouette {
 public:
  explicit Silhouette(const Mesh& mesh);

  /// Finds the silhouette as seen from `eye` (cm, body axes), where 1 cm is about `scale` pixels.
  void find(const glm::vec3& eye, float scale);

  /// Return the edge quads as vertices and indices: two triangles, six indices, per edge of the
  /// silhouette.
  const std::vector<EdgeQuadVertex>& edge_quads() const { return edge_quads_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }

  /// Returns, in indices, the end of the edge quads of each part.
  const std::vector<std::size_t>& part_ends() const { return part_ends_; }

  /// Returns for each vertex of the mesh its offset in half pixels: -1 on the silhouette, less for
  /// adjacent vertices within half a pixel of it, where triangles would otherwise fold over, and 0
  /// elsewhere.
  const std::vector<float>& offsets() const { return offsets_; }

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    glm::vec3 normal;  ///< Of any length.
  };
  struct Edge {
    std::array<std::uint32_t, 2> ends;
    std::array<std::uint32_t, 2> triangles;
  };

  void shrink(const glm::vec3& eye, float scale);
  void add_edge_quad(const Edge& edge);

  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> first_at_;  ///< For each vertex, the first one at the same position.
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> edge_ends_;  ///< Of each part.
  std::vector<char> seen_;              ///< For each triangle.
  std::vector<char> on_it_;             ///< For each vertex.
  std::vector<EdgeQuadVertex> edge_quads_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::size_t> part_ends_;
  std::vector<float> offsets_;
};

}  // namespace twrench::render
