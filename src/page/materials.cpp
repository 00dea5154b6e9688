#include "page/materials.h"

#include <algorithm>
#include <variant>

#include "picture/look/material.h"

namespace twrench::page {
namespace {

bool looks_alike(const PartMaterial& a, const PartMaterial& b) {
  return a.look.color == b.look.color && a.look.metallic == b.look.metallic &&
         a.look.roughness == b.look.roughness && a.is_mesh == b.is_mesh &&
         a.has_own_colors == b.has_own_colors;
}

}  // namespace

Materials materials_of(const scene::Body& body) {
  Materials materials;
  const std::vector<body::Part> parts = scene::visible_parts(body);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PartMaterial own{.look = scene::description(body, i).look,
                           .is_mesh = std::holds_alternative<body::Mesh>(parts[i].shape),
                           .has_own_colors = picture::has_own_colors(parts[i])};
    const auto same = [&](const PartMaterial& other) { return looks_alike(own, other); };
    const auto found = std::ranges::find_if(materials.kinds, same);
    materials.of_part.push_back(static_cast<std::size_t>(found - materials.kinds.begin()));
    if (found == materials.kinds.end()) materials.kinds.push_back(own);
  }
  return materials;
}

}  // namespace twrench::page
