#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace twrench {

/// The linear light, 0 to 1, of an sRGB value from 0 to 255 (IEC 61966-2-1).
double linear_from_srgb(double value);

/// What the body's surface is made of, in the terms of the shader.
struct Material {
  glm::vec3 diffuse;      ///< linear albedo; black for a metal
  glm::vec3 reflectance;  ///< linear, at normal incidence: F0 of Schlick's Fresnel
  float roughness;        ///< its square is the width of the GGX distribution (Burley 2012)
};

Material material(const Look& look);

}  // namespace twrench
