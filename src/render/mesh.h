#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "body/shape.h"

namespace twrench {

/// A corner of a triangle, in the order in which the vertex shader's attributes are bound.
struct Vertex {
  glm::vec3 position;  ///< cm, body axes
  glm::vec3 normal;    ///< unit, outward
};

/// The side of a cylinder between its bevels: strips of two triangles, each between two vertices of
/// the lower ring and the two over them in the upper.
struct Side {
  std::uint32_t low, high;  ///< the first vertex of each ring, counter-clockwise seen from the top
  std::uint32_t count;      ///< of the vertices of a ring, and of the strips
  std::size_t begin;        ///< in indices; from here to the end of its part
};

/// Triangles, three indices each, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::size_t> vertex_ends;    ///< in vertices, the end of each part's own
  std::vector<std::size_t> part_ends;      ///< in indices
  std::vector<std::optional<Side>> sides;  ///< of each part that is a cylinder
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
