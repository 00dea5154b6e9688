#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "picture/body/intersections.h"
#include "picture/body/mesh.h"

namespace twrench::picture {

/// How far a vertex is moved on the screen; a vec4 in the vertex shader.
struct Shift {
  /// The direction in body axes. Its length, if more than 1, multiplies the distance.
  glm::vec3 direction;
  /// Half pixels in that direction: -1 inside, 1 outside.
  float offset;
};

/// A vertex of an edge quad, with members in the order of the vertex shader's attributes.
struct EdgeQuadVertex {
  /// Position on the silhouette in body axes, cm.
  glm::vec3 position;
  /// Unit surface normal there.
  glm::vec3 normal;
  Shift shift;
  /// 0 on the body to 1 outside of it.
  float transparency;
  /// Depth offset towards the eye in pixels.
  float lift;
  /// Linear colour; only for a mesh with colours.
  glm::vec3 color;
};

/// The silhouette of a closed mesh: the edges between a front-facing and a back-facing triangle. It
/// gives antialiased edges at the cost of one sample per pixel: the body is shrunk by half a pixel
/// along its silhouette, and edge quads one pixel wide, whose coverage falls from 1 to 0, are drawn
/// over it (Sander, Hoppe, Snyder and Gortler, "Discontinuity edge overdraw", I3D 2001). A crease
/// between two triangles that both face the eye gets two quads of half a pixel. In each, one
/// triangle fades out over the other. An edge along which a part enters another one gets quads of
/// about one pixel on each of the two parts.
class Silhouette {
 public:
  /// The intersections are those of the mesh's parts, see find_intersections().
  Silhouette(const Mesh& mesh, PartIntersections intersections);

  /// Finds the silhouette as seen from `eye` (cm, body axes), where 1 cm is about `scale` pixels.
  void find(const glm::vec3& eye, float scale);

  /// Return the edge quads as vertices and indices: two triangles, six indices, per edge of the
  /// silhouette and per intersection edge of an earlier part, and twice that per crease and per
  /// intersection edge of a later part.
  const std::vector<EdgeQuadVertex>& edge_quads() const { return edge_quads_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }

  /// Returns, in indices, the end of the edge quads of each part.
  const std::vector<std::size_t>& part_ends() const { return part_ends_; }

  /// Returns for each vertex of the mesh how it is moved: by -1 on the silhouette, by less for
  /// adjacent vertices within half a pixel of it (triangles would otherwise fold over), and by 0
  /// elsewhere.
  const std::vector<Shift>& shifts() const { return shifts_; }

  /// Returns for each triangle of the mesh whether it faces the eye.
  const std::vector<char>& faces_eye() const { return faces_eye_; }

 private:
  /// The planes of the triangles, by a corner and a normal of any length.
  struct Planes {
    std::vector<float> x, y, z, normal_x, normal_y, normal_z;
  };
  /// An edge, by its half-edges in the two triangles.
  struct Edge {
    std::uint32_t half_edge, other;
    bool is_hollow, is_crease;
  };
  /// The ends of a part's triangles, edges and vertices.
  struct Part {
    std::size_t triangle_end, edge_end, vertex_end;
    bool has_creases;
  };

  void add_planes();
  void add_edges(const Part& begin, const Part& part);
  glm::vec3 normal_of(std::uint32_t half_edge) const;
  bool is_hollow(std::uint32_t half_edge, std::uint32_t other) const;
  bool is_crease(std::uint32_t half_edge, std::uint32_t other) const;
  void face(const glm::vec3& eye);
  void find_outline(const Part& begin, const Part& part);
  void point_outward(const Part& begin, const Part& part, const glm::vec3& eye);
  void walk_inside(const Edge& edge, const glm::vec3& eye, float scale);
  glm::vec3 normal_inside(std::uint32_t vertex) const;
  void add_edge_quad(const Edge& edge);
  void add_crease_quad(std::uint32_t half_edge, const glm::vec3& eye);
  void add_intersection_quads(const IntersectionEdge& edge, const glm::vec3& eye, float scale);
  EdgeQuadVertex quad_vertex(std::uint32_t vertex) const;
  void add_quad(const std::array<EdgeQuadVertex, 4>& corners);
  void shrink(const Part& begin, const Part& part, const glm::vec3& eye, float scale);
  std::uint32_t place(std::size_t half_edge) const { return first_at_[corners_[half_edge]]; }
  bool is_seen(std::uint32_t half_edge) const { return faces_eye_[half_edge / 3] != 0; }
  /// Returns the half-edge of an edge of the outline in the triangle that faces the eye.
  std::uint32_t seen_half_edge(const Edge& edge) const {
    return is_seen(edge.half_edge) ? edge.half_edge : edge.other;
  }

  std::vector<Vertex> vertices_;
  std::vector<glm::vec3> colors_;
  std::vector<std::uint32_t> corners_;   ///< The mesh's indices.
  std::vector<std::uint32_t> first_at_;  ///< For each vertex, its part's first in the same place.
  std::vector<std::uint32_t> opposite_;  ///< For each half-edge of the mesh.
  Planes planes_;
  std::vector<Edge> edges_;
  std::vector<Part> parts_;
  PartIntersections intersections_;
  std::vector<char> faces_eye_;
  std::vector<char> on_it_;                ///< For each vertex.
  std::vector<glm::vec3> normals_inside_;  ///< For each vertex, of any length; for a mesh.
  std::vector<Edge> outline_, creases_;    ///< Edges of the part in progress.
  std::vector<EdgeQuadVertex> edge_quads_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::size_t> part_ends_;
  std::vector<Shift> shifts_;
};

}  // namespace twrench::picture
