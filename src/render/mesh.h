#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "body/shape.h"

namespace twrench {

/// A corner of a triangle, in the order in which the vertex shader's attributes are bound.
struct Vertex {
  glm::vec3 position;  ///< cm, body axes
  glm::vec3 normal;    ///< unit, outward
};

/// Triangles, three indices each, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> vertex_ends;  ///< in vertices, the end of each part's own
  std::vector<std::size_t> part_ends;    ///< in indices
};

/// The closed surface of a part, in body axes. Rims of cylinders and edges of boxes are rounded by
/// a small bevel, so that they catch a line of light: 4 % of the smallest half dimension, or, for a
/// narrower line would be drawn in dashes, 12 tolerances, but at most 12 %. All other vertices lie
/// on the exact shape, and the facets between them depart from it by no more than `tolerance` cm.
/// Facets finer than that cost much: thin triangles are drawn badly.
Mesh part_mesh(const Part& part, double tolerance);

/// The meshes of all parts in one.
Mesh body_mesh(std::span<const Part> parts, double tolerance);

}  // namespace twrench
