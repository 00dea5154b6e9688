#include "picture/look/studio.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

namespace twrench::picture {
namespace {

/// Returns a softbox at `centre` with `width`, `height` and level sides, which faces the body.
AreaLight facing_body(const glm::vec3& centre, float width, float height,
                      const glm::vec3& radiance) {
  const glm::vec3 back = glm::normalize(centre);
  const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
  return {centre, 0.5F * width * across, 0.5F * height * glm::cross(back, across), radiance};
}

}  // namespace

AmbientLight ambient_light(const Studio& studio) {
  // The integrals of the room's radiance in studio.glsl over the sphere, alone and times y.
  AmbientLight light{(2.0F * studio.above + studio.below) / 3.0F, glm::mat3(0)};
  light.slope[1] = (studio.above - studio.below) / 3.0F;
  light.mean += studio.behind / 12.0F;
  light.slope[2] = -7.0F / 48.0F * studio.behind;
  for (const AreaLight& each : studio.lights) {
    const float distance = glm::length(each.centre);
    const float solid_angle =
        4 * glm::length(each.across) * glm::length(each.along) / (distance * distance);
    const glm::vec3 share = solid_angle / (4 * std::numbers::pi_v<float>)*each.radiance;
    light.mean += share;
    // A cosine keeps 2/3 of the first moment, and all of the mean.
    light.slope += 2.0F * glm::outerProduct(share, each.centre / distance);
  }
  return light;
}

Studio dark_studio() {
  const glm::vec3 warm(1.05F, 0.97F, 0.86F);
  const glm::vec3 neutral(1.03F, 1.0F, 0.95F);
  const glm::vec3 cool(0.93F, 0.99F, 1.06F);
  return {{facing_body({3.69F, 4.17F, 2.3F}, 3.66F, 2.53F, 12.0F * warm),
           facing_body({-1.99F, 0.02F, 1.09F}, 1.21F, 1.68F, 3.0F * cool),
           facing_body({-0.19F, 1.82F, 1.58F}, 1.37F, 2.29F, 2.12F * neutral),
           facing_body({0.21F, 2.17F, -0.87F}, 0.67F, 0.51F, 21.2F * neutral),
           facing_body({-0.39F, 2.17F, -2.8F}, 1.24F, 1.38F, 3.7F * neutral)},
          {0.045F, 0.046F, 0.051F},
          {0.235F, 0.238F, 0.255F},
          {0.50F, 0.51F, 0.54F}};
}

Studio white_studio() {
  const glm::vec3 white(1.0F, 0.99F, 0.98F);
  return {{facing_body({2.4F, 1.9F, 1.7F}, 1.8F, 3.8F, 5.4F * white),
           facing_body({-2.6F, 0.6F, 2.2F}, 1.3F, 3.4F, 3.4F * white),
           facing_body({-0.8F, 3.1F, 1.0F}, 3.4F, 1.3F, 4.2F * white),
           facing_body({0.0F, -3.0F, 0.8F}, 4.0F, 1.6F, 0.8F * white),
           facing_body({0.2F, 0.4F, 3.6F}, 2.6F, 1.4F, 0.25F * white)},
          {0.22F, 0.223F, 0.228F},
          {0.17F, 0.171F, 0.175F},
          {0.0F, 0.0F, 0.0F}};
}

Studio sunlight() {
  const glm::vec3 sun(1.0F, 0.97F, 0.92F);
  const glm::vec3 cool(0.55F, 0.75F, 1.0F);
  return {{facing_body({2.3F, 2.0F, 1.6F}, 1.1F, 2.6F, 9.0F * sun),
           facing_body({-2.4F, -1.2F, 1.6F}, 1.8F, 2.8F, 0.9F * cool),
           facing_body({-0.6F, 3.1F, 0.8F}, 2.6F, 1.0F, 3.0F * sun),
           facing_body({-2.6F, 1.2F, -2.2F}, 0.8F, 3.2F, 5.0F * cool),
           facing_body({1.7F, -1.7F, -2.6F}, 4.2F, 0.9F, 2.2F * cool)},
          {0.018F, 0.020F, 0.026F},
          {0.10F, 0.112F, 0.14F},
          {0.30F, 0.36F, 0.46F}};
}

}  // namespace twrench::picture
