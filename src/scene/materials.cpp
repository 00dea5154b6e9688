#include "scene/materials.h"

#include <iterator>

#include "base/words.h"

namespace twrench::scene {

// The colours of steel (there: iron), brass and wood are those of the reference sheet "Material
// Properties" of Google's renderer Filament. Its rubber, #353535, would be invisible against a dark
// background, so it is lighter here. Rock reflects 0.3 of the light, as dry rock does, and is a
// little warmer than grey. The other colours, and the roughness of each material, are chosen by
// eye.
const std::vector<Material>& materials() {
  static const std::vector<Material> all{
      {"steel", {192, 189, 186}, 1.0, 0.25}, {"brass", {244, 228, 173}, 1.0, 0.25},
      {"wood", {135, 92, 60}, 0.0, 0.6},     {"plastic", {200, 204, 210}, 0.0, 0.35},
      {"rubber", {72, 70, 68}, 0.0, 0.7},    {"rock", {152, 147, 139}, 0.0, 0.95},
      {"paper", {240, 236, 224}, 0.0, 0.9},
  };
  return all;
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  std::ranges::transform(materials(), std::back_inserter(names), &Material::name);
  return names;
}

const Material& find_material(const std::string& name, const std::string& what) {
  const auto found = std::ranges::find(materials(), name, &Material::name);
  if (found == materials().end()) throw unknown_name(what, name, material_names());
  return *found;
}

}  // namespace twrench::scene
