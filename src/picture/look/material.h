#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace twrench::picture {

/// Returns the linear light, 0 to 1, of an sRGB value from 0 to 255 (IEC 61966-2-1).
double linear_from_srgb(double value);

/// Reflectance at normal incidence of paint: F0 of a refractive index of 1.5.
inline constexpr double dielectric_reflectance = 0.04;

/// The material of the body, as the shader needs it.
struct Material {
  /// Linear colour. It multiplies the colours of vertices.
  glm::vec3 color;
  /// Linear diffuse albedo; black for metals.
  glm::vec3 diffuse;
  /// Linear reflectance at normal incidence: F0 of Schlick's Fresnel term.
  glm::vec3 reflectance;
  /// Standard deviation of the slopes of the scratches that brushing leaves, across them;
  /// 0 for paint.
  float brushing;
  /// Perceptual roughness; its square is alpha of the GGX distribution (Burley 2012).
  float roughness;
  /// Metalness, 0 (paint) to 1 (metal), which determines how a vertex's colour is divided between
  /// diffuse albedo and reflectance.
  float metalness;
  /// Whether it has the relief of regolith, and scatters light as dust does.
  bool is_rock;

  bool operator==(const Material&) const = default;
};

/// How a surface reflects, whatever its colour.
struct Finish {
  double metallic;   ///< Metalness, 0 (paint) to 1 (metal).
  double roughness;  ///< Roughness, 0.05 (mirror) to 1 (chalk).
};

/// Whether the part is a mesh whose file gives colours of vertices.
bool has_own_colors(const body::Part& part);

/// Returns the finish of a part. Values that are set neither by its look nor by the body's are
/// those of the theme or, for a mesh with colours of its own, those of plastic.
Finish finish(const scene::Look& look, const scene::PartLook& part, bool has_own_colors);

/// Returns the material of a body with that look, or of a part that has its own look or colours;
/// with these it is white.
Material material(const scene::Look& look, const scene::PartLook& part = {},
                  bool has_own_colors = false);

}  // namespace twrench::picture
