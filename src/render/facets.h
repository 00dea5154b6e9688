#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "render/mesh.h"

namespace twrench {

/// Triangles between the vertices of a mesh, as its own are.
struct Facets {
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> part_ends;    ///< in indices, the end of each part's own
  std::vector<std::size_t> side_begins;  ///< where, before it, those of a cylinder's side begin
  double depth = 0;                      ///< cm: how deep they lie under the mesh's own at most
};

/// The mesh as it is seen from `eye`, cm, body axes, in fewer triangles: a software rasteriser pays
/// for whole blocks of pixels along each edge. On the side of a cylinder up to four strips become
/// one, the fewer the nearer to the outline, which stays as it is; where they are turned away there
/// are none. What is seen has no gap. A wide facet lies deep in the cylinder, but the shader, which
/// knows the cylinder, shades as if it did not.
Facets facets_seen(const Mesh& mesh, const glm::vec3& eye);

}  // namespace twrench
