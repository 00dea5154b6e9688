#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace twrench {

/// A soft box: a rectangle that shines evenly. Places are on the stage: the camera's axes (x right,
/// y up, z to the camera), the body's centre at the origin, and its bounding radius 1.
struct AreaLight {
  glm::vec3 centre;
  glm::vec3 across;    ///< half of one side; at right angles to `along`
  glm::vec3 along;     ///< half of the other
  glm::vec3 radiance;  ///< linear
};

/// The light around the body: it is fixed to the camera, and the body tumbles in it.
struct Studio {
  static constexpr int light_count = 5;

  std::array<AreaLight, light_count> lights;
  glm::vec3 above;  ///< radiance of the room overhead, linear
  glm::vec3 below;  ///< and of its floor
};

/// The dark studio: a large key light, a cool fill, a light overhead and two rims from behind.
Studio dark_studio();

/// The white one: large soft boxes in a bright room, and nothing from behind, so that outlines are
/// dark before the white (bright-field lighting).
Studio white_studio();

/// In space: one small sun, its light thrown back faintly from below.
Studio sunlight();

}  // namespace twrench
