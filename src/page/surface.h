#pragma once

#include <vector>

#include "page/simplification.h"
#include "picture/body/mesh.h"
#include "scene/scene.h"

namespace twrench::page {

/// What a page draws of a body.
struct Surface {
  /// The visible parts, with gaps closed.
  std::vector<body::Part> parts;
  /// Bounding radius of the visible parts, cm.
  double radius;
  /// As fine as the size of a page allows.
  picture::Mesh mesh;
  /// Set if triangles were taken out of the parts that are given by triangles.
  std::optional<Simplification> simplification;
};

/// Returns what a page draws of a body, with at most some 5000 vertices for shapes, as far as
/// facets stay invisible, and 20 000 triangles for meshes.
Surface surface_of(const scene::Body& body);

}  // namespace twrench::page
