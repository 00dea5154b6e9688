#pragma once

#include <twrench/body/triangle_mesh.h>

#include <cstddef>

namespace twrench::mesh {

/// The changes made by welding.
struct Welded {
  std::size_t joined_vertices = 0;    ///< Vertices that were apart and were joined to others.
  std::size_t removed_triangles = 0;  ///< Triangles that had two corners joined.
};

/// Joins the vertices that coincide, and those that are no farther apart than `tolerance`, directly
/// or from one to the next; each group becomes its first vertex. Removes the triangles that lose a
/// corner and the vertices that no triangle uses. The running time grows with the number of
/// vertices within the tolerance of each other.
Welded weld(body::TriangleMesh& mesh, double tolerance);

}  // namespace twrench::mesh
