#pragma once

#include <twrench/body/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace twrench::mesh {

/// The polygons of a file that is being read, as triangles of a mesh. The vertices of a polygon may
/// follow it in the file, so it can be split properly only at the end.
class Polygons {
 public:
  /// Adds a polygon of three corners or more to the mesh, as a fan about its first corner.
  void add(std::span<const std::uint32_t> ring, body::TriangleMesh& mesh);

  /// Splits the concave polygons again whose fans do not lie within them. A polygon that crosses
  /// itself as seen along its normal cannot be split and remains a fan; so do the rest if splitting
  /// takes too long. Call once, after all vertices have been read and all indices are known to be
  /// in range.
  void triangulate(body::TriangleMesh& mesh) const;

 private:
  /// The triangles of a polygon of more than three corners.
  struct Fan {
    std::size_t first;  ///< Index in the mesh.
    std::size_t count;
  };

  std::vector<Fan> fans_;
};

}  // namespace twrench::mesh
