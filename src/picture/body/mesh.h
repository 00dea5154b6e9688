#pragma once

#include <twrench/body/shape.h>

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "picture/shapes/rings.h"
#include "scene/scene.h"

namespace twrench::picture {

/// A vertex, with members in the order of the vertex shader's attributes.
struct Vertex {
  glm::vec3 position;  ///< Position in body axes, cm.
  glm::vec3 normal;    ///< Outward unit normal.
};

/// The side of a cylinder, a capsule or a tube between its bevels: strips of two triangles, each
/// between two vertices of the lower ring and the two above them in the upper one.
struct CylinderSide {
  std::uint32_t low, high;  ///< First vertex of each ring, counter-clockwise as seen from the top.
  std::uint32_t count;      ///< Number of vertices of a ring, and of strips.
  std::size_t begin;        ///< In indices; from here to the end of its part.
  double bevel;             ///< Radius of the rounded rims, cm; 0 for a capsule.
  /// How many strips one facet may replace: 1 if other parts enter the side. A wide facet lies
  /// below the side, and they would enter it elsewhere.
  std::uint32_t most_merged = 4;
};

/// Triangles of a part that lie close together.
struct Cluster {
  std::size_t begin, end;  ///< In indices.
  glm::vec3 centre;        ///< Position in body axes, cm.
};

/// Triangles, three indices each, counter-clockwise as seen from outside.
struct Mesh {
  /// Vertices of all triangles.
  std::vector<Vertex> vertices;
  /// Linear colours of the vertices, 0 to 1, which multiply the colour of the part's material.
  /// Empty if no part has them. Vertices of parts without vertex colours are black.
  std::vector<glm::vec3> colors;
  /// Three per triangle.
  std::vector<std::uint32_t> indices;
  /// In vertices, the end of each part.
  std::vector<std::size_t> vertex_ends;
  /// In indices, the end of each part.
  std::vector<std::size_t> part_ends;
  /// For each part, its side if it has the side of a cylinder.
  std::vector<std::optional<CylinderSide>> sides;
  /// For each part, its clusters if it is given by triangles: such a part may have creases, where
  /// there are several vertices with different normals in one place, and hollows.
  std::vector<std::vector<Cluster>> clusters;
  /// For each part, whether it has vertex colours.
  std::vector<char> is_colored;
};

/// Returns the closed surface of a part in body axes. Sharp rims of solids of revolution and edges
/// of boxes have a small rounded bevel to catch a highlight: 4 % (boxes: 8 %) of the smallest half
/// dimension, or 12 tolerances but at most 12 %, because a narrower line would look dashed. All
/// other vertices lie on the exact shape, and the facets between them deviate from it by at most
/// `tolerance` cm. Much finer facets are expensive: thin triangles rasterise poorly. A body::Mesh
/// has its own triangles, see triangle_surface(). They are smooth where adjacent ones meet at no
/// more than `crease_angle` rad.
Mesh part_mesh(const body::Part& part, double tolerance,
               double crease_angle = scene::PartLook().crease_angle);

/// Returns the surface of a part in body axes whose shape has these rings.
Mesh surface_of_rings(const body::Part& part, const Rings& surface);

/// Returns the meshes of all parts merged into one. `looks` are the looks of the first parts, in
/// order; the other parts have the default look.
Mesh body_mesh(std::span<const body::Part> parts, double tolerance,
               std::span<const scene::PartLook> looks = {});

}  // namespace twrench::picture
