#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace twrench::picture {

/// A rectangular area light with uniform radiance (a softbox). Coordinates are those of the stage:
/// the camera's axes (x right, y up, z towards the camera), with the body's centre at the origin
/// and its bounding radius scaled to 1.
struct AreaLight {
  /// Centre of the rectangle.
  glm::vec3 centre;
  /// Half of one side, perpendicular to `along`.
  glm::vec3 across;
  /// Half of the other side.
  glm::vec3 along;
  /// Linear radiance.
  glm::vec3 radiance;
};

/// The lights around the body. They are fixed to the camera; the body tumbles in them.
struct Studio {
  static constexpr int light_count = 5;

  /// The area lights.
  std::array<AreaLight, light_count> lights;
  /// Linear radiance of the room from above.
  glm::vec3 above;
  /// Linear radiance of the room from below.
  glm::vec3 below;
  /// Linear radiance that is added behind the body, as seen from the camera. Surfaces mirror it
  /// where they turn away from the eye, so it separates the body's outline from a dark background.
  glm::vec3 behind;
};

/// The radiance of the studio, so blurred that it varies linearly with the direction: it is
/// mean + slope * direction.
struct AmbientLight {
  glm::vec3 mean;
  glm::mat3 slope;
};

/// Returns the ambient light at the body's centre: the mean of the radiance over all directions,
/// and its slope as the clamped cosine of a diffuse surface sees it.
AmbientLight ambient_light(const Studio& studio);

/// Returns the dark studio: a large key light, a cool fill, an overhead light and two rim lights.
Studio dark_studio();

/// Returns the white studio: large softboxes in a bright room and no rim lights, so that
/// silhouettes are dark against the white (bright-field lighting).
Studio white_studio();

/// Returns the lights in space: one small sun, with faint light from below.
Studio sunlight();

}  // namespace twrench::picture
