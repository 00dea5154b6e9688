#pragma once

#include <vector>

#include "page/simplification.h"
#include "render/body/mesh.h"
#include "scene/scene.h"

namespace twrench::page {

/// What a page draws of a body.
struct Surface {
  /// The visible parts, with gaps closed.
  std::vector<body::Part> parts;
  /// Bounding radius of the visible parts, cm.
  double radius;
  /// As fine as a page may be large.
  render::Mesh mesh;
  /// Where that has fewer triangles than one would like, how many.
  std::optional<Simplification> simplification;
};

Surface surface_of(const scene::Body& body);

}  // namespace twrench::page
