#pragma once

#include <vector>

#include "scene/scene.h"

namespace twrench::page {

/// What decides on the program that draws a part.
struct PartMaterial {
  /// The look of the part.
  scene::PartLook look;
  /// Whether its vertices have colours of their own.
  bool is_colored;
};

/// The materials of a body.
struct Materials {
  /// Those that differ.
  std::vector<PartMaterial> kinds;
  /// For each part, the index of its own.
  std::vector<std::size_t> of_part;
};

Materials materials_of(const scene::Body& body);

}  // namespace twrench::page
