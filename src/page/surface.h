#pragma once

#include <vector>

#include "page/simplification.h"
#include "picture/body/mesh.h"
#include "scene/scene.h"

namespace twrench::page {

/// The surface of a body, as a page draws it.
struct Surface {
  /// The visible parts, with gaps closed.
  std::vector<body::Part> parts;
  /// Bounding radius of the visible parts, cm.
  double radius;
  /// The mesh, as fine as the size of a page allows.
  picture::Mesh mesh;
  /// Set if triangles were removed from the parts that are given as triangles.
  std::optional<Simplification> simplification;
};

/// Returns the surface of a body, with at most about 5000 vertices for shapes, as far as facets
/// stay invisible, and 20 000 triangles for meshes.
Surface surface_of(const scene::Body& body);

}  // namespace twrench::page
