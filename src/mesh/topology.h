#pragma once

#include <twrench/body/triangle_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twrench::mesh {

/// An edge in the direction of one of its triangles, from vertex to vertex.
using DirectedEdge = std::array<std::uint32_t, 2>;

/// How the triangles of a mesh meet at their edges.
struct Topology {
  /// Edges of only one triangle, in the direction of that triangle.
  std::vector<DirectedEdge> open;
  /// Edges of more than two triangles whose numbers in the two directions differ.
  std::vector<DirectedEdge> branching;
  /// Edges of more than two triangles, as many in each direction, that nevertheless bound no solid
  /// around the edge.
  std::vector<DirectedEdge> overlapping;
  /// Edges along which two triangles run in the same direction.
  std::vector<DirectedEdge> opposed;
  /// Edges along which the numbers of triangles in the two directions differ.
  std::size_t unbalanced = 0;
  /// The component of each triangle. Triangles that share an edge are in the same component.
  /// Components are numbered from 0 in the order of their first triangles.
  std::vector<std::uint32_t> component;
  std::size_t components = 0;

  /// Returns whether the triangles bound a solid around each edge. Bodies may touch along an edge.
  bool is_closed() const {
    return open.empty() && branching.empty() && overlapping.empty() && opposed.empty();
  }
};

/// Returns how the triangles meet. Coincident vertices must already be joined.
Topology topology(const body::TriangleMesh& mesh);

/// A triangle at an edge: its third vertex, and whether it runs along the edge from its first end
/// to its second.
struct EdgeTriangle {
  std::uint32_t vertex;
  bool is_forward;
};

/// Returns whether closed surfaces that touch along an edge bound a solid there: whether, on a way
/// around the edge, each triangle that leads into the solid is followed by one that leads out of
/// it. Triangles that lie on each other may follow in any order. False if the solid would count
/// twice between some of the triangles, if some are turned over, or if a triangle has no area. Both
/// directions must have the same number of triangles.
bool bounds_solid(const body::TriangleMesh& mesh, std::uint32_t from, std::uint32_t to,
                  std::span<const EdgeTriangle> triangles);

}  // namespace twrench::mesh
