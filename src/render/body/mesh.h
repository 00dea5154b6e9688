#pragma once

#include <twrench/body/shape.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace twrench::render {

/// A vertex, with members in the order of the vertex shader's attributes.
struct Vertex {
  glm::vec3 position;  ///< Position in body axes, cm.
  glm::vec3 normal;    ///< Outward unit normal.
};

/// The side of a cylinder between its bevels: strips of two triangles, each between two vertices of
/// the lower ring and the two above them in the upper one.
struct CylinderSide {
  std::uint32_t low, high;  ///< First vertex of each ring, counter-clockwise as seen from the top.
  std::uint32_t count;      ///< Number of vertices of a ring, and of strips.
  std::size_t begin;        ///< In indices; from here to the end of its part.
  double bevel;             ///< Radius of the rounded rims, cm.
};

/// Triangles, three indices each, counter-clockwise as seen from outside.
struct Mesh {
  /// Vertices of all triangles.
  std::vector<Vertex> vertices;
  /// Three per triangle.
  std::vector<std::uint32_t> indices;
  /// In vertices, the end of each part.
  std::vector<std::size_t> vertex_ends;
  /// In indices, the end of each part.
  std::vector<std::size_t> part_ends;
  /// For each part its side, if it is a cylinder.
  std::vector<std::optional<CylinderSide>> sides;
};

/// Returns the closed surface of a part in body axes. The rims of cylinders and edges of boxes have
/// a small rounded bevel to catch a highlight: 4 % (boxes: 8 %) of the smallest half dimension, or
/// 12 tolerances but at most 12 %, because a narrower line would look dashed. All other vertices
/// lie on the exact shape, and the facets between them deviate from it by at most `tolerance` cm.
/// Much finer facets are expensive: thin triangles rasterise poorly.
Mesh part_mesh(const body::Part& part, double tolerance);

/// Returns the meshes of all parts merged into one.
Mesh body_mesh(std::span<const body::Part> parts, double tolerance);

}  // namespace twrench::render
