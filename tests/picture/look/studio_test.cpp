#include "picture/look/studio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace twrench::picture {
namespace {

Studio dark_room() {
  Studio studio = dark_studio();
  studio.above = studio.below = studio.behind = glm::vec3(0);
  for (AreaLight& light : studio.lights) light.radiance = glm::vec3(0);
  return studio;
}

TEST(AmbientLight, IsEvenInAnEvenRoom) {
  Studio studio = dark_room();
  studio.above = studio.below = glm::vec3(0.25F, 0.5F, 0.75F);
  const AmbientLight light = ambient_light(studio);
  EXPECT_LT(glm::distance(light.mean, studio.above), 1e-6F);
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::length(light.slope[i]), 1e-6F);
}

// The room is below + (above - below) h (2 - h), where h goes from 0 at the bottom to 1 at the top.
TEST(AmbientLight, OfTheRoomIsItsMeanAndWhatADiffuseSurfaceSees) {
  Studio studio = dark_room();
  studio.above = glm::vec3(0.9F);
  studio.below = glm::vec3(0.3F);
  double mean = 0, moment = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    const double h = (i + 0.5) / steps;
    const double room = 0.3 + 0.6 * h * (2 - h);
    mean += room / steps;
    moment += room * (2 * h - 1) / steps;
  }
  const AmbientLight light = ambient_light(studio);
  EXPECT_NEAR(light.mean.x, mean, 1e-5);
  EXPECT_NEAR(light.slope[1].x, 2 * moment, 1e-5);
}

// The light behind the body is (2 c - 1)^2 at the angle arccos(c) < 60 degrees from its middle.
TEST(AmbientLight, OfTheLightBehindIsItsMeanAndWhatADiffuseSurfaceSees) {
  Studio studio = dark_room();
  studio.behind = glm::vec3(0.6F);
  double mean = 0, moment = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    const double c = 0.5 + 0.5 * (i + 0.5) / steps;
    const double radiance = 0.6 * (2 * c - 1) * (2 * c - 1);
    mean += radiance / 4 / steps;
    moment += radiance * c / 4 / steps;
  }
  const AmbientLight light = ambient_light(studio);
  EXPECT_NEAR(light.mean.x, mean, 1e-6);
  EXPECT_NEAR(light.slope[2].x, -2 * moment, 1e-6);
}

TEST(AmbientLight, OfALampComesFromItsSide) {
  Studio studio = dark_room();
  AreaLight& lamp = studio.lights[0];
  lamp = {{0, 0, 4}, {0.5F, 0, 0}, {0, 1, 0}, {8, 4, 2}};
  const double solid_angle = 1.0 * 2.0 / 16;
  const AmbientLight light = ambient_light(studio);
  EXPECT_NEAR(light.mean.x, 8 * solid_angle / (4 * std::numbers::pi), 1e-6);
  EXPECT_NEAR(light.mean.z, 2 * solid_angle / (4 * std::numbers::pi), 1e-6);
  EXPECT_NEAR(light.slope[2].x, 2 * light.mean.x, 1e-6);
  EXPECT_EQ(light.slope[0], glm::vec3(0));
}

}  // namespace
}  // namespace twrench::picture
