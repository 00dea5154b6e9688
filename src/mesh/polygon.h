#pragma once

#include <twrench/body/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twrench::mesh {

/// The polygons of a file that is being read, as triangles of a mesh. The vertices of a polygon may
/// stand behind it in the file; how to split it shows only once they are known.
class Polygons {
 public:
  /// Adds a polygon of three corners or more to the mesh, as a fan about its first corner.
  void add(std::span<const std::uint32_t> ring, body::TriangleMesh& mesh);

  /// Splits those polygons anew whose fan does not lie within them, because they are concave. One
  /// that cannot be split within, because it crosses itself as seen along its normal, remains a
  /// fan; so do all where that would take too long. To be called once, when all vertices are there
  /// and all indices are in range.
  void triangulate(body::TriangleMesh& mesh) const;

 private:
  /// The triangles of a polygon of more than three corners.
  struct Fan {
    std::size_t first;  ///< In the mesh.
    std::size_t count;
  };

  std::vector<Fan> fans_;
};

}  // namespace twrench::mesh
