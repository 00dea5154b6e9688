#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "picture/body/mesh.h"

namespace twrench::picture {

struct PartModel;

/// A segment of the curve in which the surfaces of two parts intersect, as an edge of one of them.
struct IntersectionEdge {
  /// The triangle that ends here, and the other part's triangle, behind which it continues, as
  /// numbers of triangles in the mesh.
  std::uint32_t triangle, other;
  /// The ends. Seen from outside, the visible side of the triangle is on the left. Normals are
  /// interpolated between those of its corners, so they are not longer than 1.
  std::array<Vertex, 2> ends;
  /// Linear colours at the ends; only for a mesh with colours.
  std::array<glm::vec3, 2> colors;
};

/// For each part, the edges along which its surface enters other parts.
using PartIntersections = std::vector<std::vector<IntersectionEdge>>;

/// Finds the intersections of the parts of a mesh; parts that only touch have none. A part that
/// fades out over a cylinder in the shader (see contact_coverage in occluders.glsl) has none with
/// it.
PartIntersections find_intersections(const Mesh& mesh, std::span<const PartModel> parts);

}  // namespace twrench::picture
