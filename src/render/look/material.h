#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace twrench::render {

/// Returns the linear light, 0 to 1, of an sRGB value from 0 to 255 (IEC 61966-2-1).
double linear_from_srgb(double value);

/// The material of the body, as the shader needs it.
struct Material {
  /// Linear diffuse albedo; black for metals.
  glm::vec3 diffuse;
  /// Linear reflectance at normal incidence: F0 of Schlick's Fresnel term.
  glm::vec3 reflectance;
  /// Standard deviation of the slopes of the scratches that brushing leaves, across them;
  /// 0 for paint.
  float brushing;
  /// Perceptual roughness; its square is alpha of the GGX distribution (Burley 2012).
  float roughness;
};

Material material(const scene::Look& look);

}  // namespace twrench::render
