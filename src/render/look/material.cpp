#include "render/look/material.h"

#include <cmath>

#include "render/look/theme.h"
#include "render/space/glm_from_eigen.h"

namespace twrench::render {

double linear_from_srgb(double value) {
  const double s = value / 255;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

Material material(const scene::Look& look, const scene::PartLook& part) {
  const ThemeStyle& style = style_of(look.theme);
  const scene::Color srgb = part.color.value_or(look.color.value_or(style.metal));
  const double metallic = part.metallic.value_or(look.metallic.value_or(style.metallic));
  const Eigen::Vector3d color(linear_from_srgb(srgb.red), linear_from_srgb(srgb.green),
                              linear_from_srgb(srgb.blue));
  const Eigen::Vector3d reflectance =
      metallic * color + (1 - metallic) * Eigen::Vector3d::Constant(dielectric_reflectance);
  const double roughness = part.roughness.value_or(look.roughness.value_or(style.roughness));
  constexpr double brushed = 0.73;  // the finer the brush, the smoother what it leaves
  return {glm_from_eigen(((1 - metallic) * color).eval()), glm_from_eigen(reflectance),
          static_cast<float>(metallic * brushed * roughness), static_cast<float>(roughness),
          static_cast<float>(metallic)};
}

}  // namespace twrench::render
