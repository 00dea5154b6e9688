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

  /// Splits anew those polygons of which the fan does not lie within them, because they are
  /// concave. One that crosses itself, as seen along its normal, remains a fan. To be called once,
  /// when all vertices are there and all indices are in range.
  void triangulate(body::TriangleMesh& mesh) const;

 private:
  /// A polygon of more than three corners.
  struct Fan {
    std::size_t first;  ///< Of its triangles.
    std::size_t count;  ///< Of its triangles.
  };

  std::vector<Fan> fans_;
};

}  // namespace twrench::mesh
