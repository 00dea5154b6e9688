#include "mesh/polygon.h"

#include <cstddef>

namespace twrench::mesh {

void add_polygon(std::span<const std::uint32_t> ring, body::TriangleMesh& mesh) {
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    mesh.triangles.push_back({ring[0], ring[k], ring[k + 1]});
  }
}

}  // namespace twrench::mesh
