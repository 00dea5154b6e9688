#pragma once

#include <vector>

#include "scene/scene.h"

namespace twrench::page {

/// The properties of a part that determine the program that draws it.
struct PartMaterial {
  /// The look of the part.
  scene::PartLook look;
  /// Whether it is a mesh, whose vertices have colours: at least their shade.
  bool is_mesh;
  /// Whether the mesh's file gives colours of vertices.
  bool has_own_colors;
};

/// The materials of a body.
struct Materials {
  /// The different materials.
  std::vector<PartMaterial> kinds;
  /// The index of each part's material.
  std::vector<std::size_t> of_part;
};

Materials materials_of(const scene::Body& body);

}  // namespace twrench::page
