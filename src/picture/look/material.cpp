#include "picture/look/material.h"

#include <cmath>
#include <variant>

#include "picture/look/theme.h"
#include "picture/space/glm_from_eigen.h"
#include "scene/materials.h"

namespace twrench::picture {

double linear_from_srgb(double value) {
  const double s = value / 255;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

bool has_own_colors(const body::Part& part) {
  const auto* const mesh = std::get_if<body::Mesh>(&part.shape);
  return mesh != nullptr && !mesh->surface->colors.empty();
}

Finish finish(const scene::Look& look, const scene::PartLook& part, bool has_own_colors) {
  const ThemeStyle& style = style_of(look.theme);
  Finish unset{style.metallic, style.roughness};
  if (has_own_colors) {
    const scene::Material plastic = scene::find_material("plastic", "material");
    unset = {plastic.metallic, plastic.roughness};
  }
  return {part.metallic.value_or(look.metallic.value_or(unset.metallic)),
          part.roughness.value_or(look.roughness.value_or(unset.roughness))};
}

Material material(const scene::Look& look, const scene::PartLook& part, bool has_own_colors) {
  const Color one = part.color.value_or(look.color.value_or(style_of(look.theme).metal));
  const Color srgb = has_own_colors ? Color{255, 255, 255} : one;
  const auto [metallic, roughness] = finish(look, part, has_own_colors);
  const Eigen::Vector3d color(linear_from_srgb(srgb.red), linear_from_srgb(srgb.green),
                              linear_from_srgb(srgb.blue));
  const Eigen::Vector3d reflectance =
      metallic * color + (1 - metallic) * Eigen::Vector3d::Constant(dielectric_reflectance);
  const scene::PartLook resolved{.color = one, .metallic = metallic, .roughness = roughness};
  constexpr double brushed = 0.73;  // finer brushing leaves a smoother surface
  return {glm_from_eigen(color),
          glm_from_eigen(((1 - metallic) * color).eval()),
          glm_from_eigen(reflectance),
          static_cast<float>(metallic * brushed * roughness),
          static_cast<float>(roughness),
          static_cast<float>(metallic),
          scene::material_name(resolved) == "rock"};
}

}  // namespace twrench::picture
