#include "render/studio.h"

#include <glm/geometric.hpp>

namespace twrench {
namespace {

/// A soft box at `centre` that faces the body, with `width` and `height`, its sides level.
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
  return {{facing_body({2.4F, 1.9F, 1.7F}, 1.7F, 3.6F, 5.0F * warm),
           facing_body({-2.5F, -0.7F, 1.9F}, 1.5F, 3.4F, 2.2F * cool),
           facing_body({-0.8F, 3.1F, 1.0F}, 3.8F, 1.4F, 4.5F * warm),
           facing_body({-2.6F, 1.4F, -2.2F}, 0.9F, 3.2F, 6.0F * cool),
           facing_body({1.7F, -1.5F, -2.6F}, 4.2F, 0.9F, 4.0F * cool)},
          {0.035F, 0.037F, 0.042F},
          {0.17F, 0.174F, 0.185F}};
}

}  // namespace twrench
