#include "render/look/studio.h"

#include <glm/geometric.hpp>

namespace twrench::render {
namespace {

/// A softbox at `centre` that faces the body, with `width` and `height` and level sides.
AreaLight facing_body(const glm::vec3& centre, float width, float height,
                      const glm::vec3& radiance) {
  const glm::vec3 back = glm::normalize(centre);
  const glm::vec3 across = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
  return {centre, 0.5F * width * across, 0.5F * height * glm::cross(back, across), radiance};
}

}  // namespace

Studio dark_studio() {
  const glm::vec3 warm(1.0F, 0.96F, 0.91F);
  const glm::vec3 cool(0.86F, 0.93F, 1.0F);
  return {{facing_body({2.4F, 1.9F, 1.7F}, 1.9F, 3.8F, 5.6F * warm),
           facing_body({-2.5F, -0.7F, 1.9F}, 1.5F, 3.4F, 2.2F * cool),
           facing_body({-0.8F, 3.1F, 1.0F}, 3.8F, 1.4F, 4.5F * warm),
           facing_body({-2.6F, 1.4F, -2.2F}, 0.9F, 3.2F, 6.0F * cool),
           facing_body({1.7F, -1.5F, -2.6F}, 4.2F, 0.9F, 4.0F * cool)},
          {0.035F, 0.037F, 0.042F},
          {0.17F, 0.174F, 0.185F}};
}

Studio white_studio() {
  const glm::vec3 white(1.0F, 0.99F, 0.98F);
  return {{facing_body({2.4F, 1.9F, 1.7F}, 1.8F, 3.8F, 5.4F * white),
           facing_body({-2.6F, 0.6F, 2.2F}, 1.3F, 3.4F, 3.4F * white),
           facing_body({-0.8F, 3.1F, 1.0F}, 3.4F, 1.3F, 4.2F * white),
           facing_body({0.0F, -3.0F, 0.8F}, 4.0F, 1.6F, 0.8F * white),
           facing_body({0.2F, 0.4F, 3.6F}, 2.6F, 1.4F, 0.25F * white)},
          {0.22F, 0.223F, 0.228F},
          {0.17F, 0.171F, 0.175F}};
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
          {0.05F, 0.056F, 0.07F}};
}

}  // namespace twrench::render
