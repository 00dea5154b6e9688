#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/mesh.h"

namespace twrench {

/// A corner of a fin, in the order in which the vertex shader's attributes are bound.
struct FinVertex {
  glm::vec3 position;  ///< on the outline: cm, body axes
  glm::vec3 normal;    ///< of the surface there, unit
  float offset;        ///< half pixels along the normal, as it is seen: -1 inside, 1 outside
};

/// The outline of a closed mesh: the edges between a triangle that is seen and one that is turned
/// away. Along it smooth edges are drawn at the cost of one sample a pixel: the body drawn in by
/// half a pixel where its outline is, and over it fins, a pixel wide, whose coverage falls from 1
/// to 0 (Sander, Hoppe, Snyder and Gortler, "Discontinuity edge overdraw", I3D 2001).
class Outline {
 public:
  explicit Outline(const Mesh& mesh);

  /// Finds the outline as it is seen from `eye`, cm, body axes, where 1 cm is about `scale` pixels.
  void find(const glm::vec3& eye, float scale);

  /// Two triangles, six indices, an edge of the outline.
  const std::vector<FinVertex>& fins() const { return fins_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }

  /// In indices, the end of the fins of each part.
  const std::vector<std::size_t>& part_ends() const { return part_ends_; }

  /// For each vertex of the mesh the half pixels by which it is moved: -1 on the outline, less on
  /// those next to it that lie less than half a pixel within, or triangles would turn over; else 0.
  const std::vector<float>& offsets() const { return offsets_; }

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    glm::vec3 normal;  ///< of any length
  };
  struct Edge {
    std::array<std::uint32_t, 2> ends;
    std::array<std::uint32_t, 2> triangles;
  };

  void draw_in(const glm::vec3& eye, float scale);
  void add_fin(const Edge& edge);

  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> first_at_;  ///< for each vertex the first one at the same place
  std::vector<Triangle> triangles_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> edge_ends_;  ///< of each part
  std::vector<char> seen_;              ///< for each triangle
  std::vector<char> on_it_;             ///< for each vertex
  std::vector<FinVertex> fins_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::size_t> part_ends_;
  std::vector<float> offsets_;
};

}  // namespace twrench
