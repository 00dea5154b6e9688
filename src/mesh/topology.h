#pragma once

#include <twrench/body/triangle_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace twrench::mesh {

/// An edge as one of its triangles runs along it, from vertex to vertex.
using DirectedEdge = std::array<std::uint32_t, 2>;

/// How the triangles of a mesh meet at their edges.
struct Topology {
  /// Edges of one triangle alone, each as that runs along it.
  std::vector<DirectedEdge> open;
  /// Edges of more than two triangles.
  std::vector<DirectedEdge> branching;
  /// Edges along which two triangles run in the same direction.
  std::vector<DirectedEdge> opposed;
  /// Edges along which not as many triangles run in one direction as in the other.
  std::size_t unbalanced = 0;
  /// The component of each triangle, from 0 in the order of their first triangles; triangles at an
  /// edge are in one.
  std::vector<std::uint32_t> component;
  std::size_t components = 0;
};

/// Returns how the triangles meet; vertices that coincide must be one.
Topology topology(const body::TriangleMesh& mesh);

}  // namespace twrench::mesh
