#pragma once

#include <twrench/body/triangle_mesh.h>

#include <cstddef>

namespace twrench::mesh {

/// What welding did.
struct Welded {
  std::size_t joined_vertices = 0;    ///< Vertices that were apart and are so no more.
  std::size_t removed_triangles = 0;  ///< Triangles two corners of which are one now.
};

/// Joins the vertices that coincide, and those that are no farther apart than `tolerance`, directly
/// or from one to the next; each group becomes its first vertex. Takes out the triangles that lose
/// a corner by it, and the vertices of no triangle. The time it takes grows with the number of
/// vertices within the tolerance of one.
Welded weld(body::TriangleMesh& mesh, double tolerance);

}  // namespace twrench::mesh
