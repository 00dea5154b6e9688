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
  const glm::vec3 warm(1.0F, 0.96F, 0.90F);
  const glm::vec3 cool(0.80F, 0.90F, 1.0F);
  return {{facing_body({2.2F, 2.6F, 1.4F}, 2.0F, 2.6F, 5.0F * warm),
           facing_body({-2.6F, 0.2F, 2.2F}, 1.2F, 3.4F, 1.6F * cool),
           facing_body({-2.4F, 1.8F, -2.4F}, 1.0F, 3.0F, 5.0F * cool),
           facing_body({2.6F, -0.8F, -2.4F}, 0.8F, 3.0F, 2.5F * cool)},
          {0.020F, 0.022F, 0.028F},
          {0.16F, 0.18F, 0.22F}};
}

}  // namespace twrench
