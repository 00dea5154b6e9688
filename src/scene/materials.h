#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/color.h"

namespace twrench::scene {

/// A material that scene files and the command line refer to by name.
struct Material {
  /// Its name.
  std::string name;
  /// Its colour; for a metal, the colour of its reflection.
  Color color;
  /// Metalness, 0 (paint) to 1 (metal).
  double metallic;
  /// Roughness, 0.05 (mirror) to 1 (chalk).
  double roughness;
};

/// Returns all materials. No two look alike.
const std::vector<Material>& materials();

/// Returns their names.
std::vector<std::string> material_names();

/// Returns the material with that name. Throws InvalidArgument about `what`, suggesting the nearest
/// name.
const Material& find_material(const std::string& name, const std::string& what);

/// Gives a Look or a PartLook the colour, the metalness and the roughness of a material.
void set_material(auto& look, const Material& material) {
  look.color = material.color;
  look.metallic = material.metallic;
  look.roughness = material.roughness;
}

/// Returns the name of the material that matches a Look or a PartLook, if any.
std::optional<std::string> material_name(const auto& look) {
  const auto found = std::ranges::find_if(materials(), [&](const Material& material) {
    return look.color == material.color && look.metallic == material.metallic &&
           look.roughness == material.roughness;
  });
  if (found == materials().end()) return std::nullopt;
  return found->name;
}

}  // namespace twrench::scene
