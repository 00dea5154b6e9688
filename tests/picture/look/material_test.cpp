#include "picture/look/material.h"

#include <gtest/gtest.h>

#include "scene/materials.h"

namespace twrench::picture {
namespace {

TEST(LinearFromSrgb, FollowsTheStandard) {
  EXPECT_EQ(linear_from_srgb(0), 0);
  EXPECT_NEAR(linear_from_srgb(10), 10 / 255.0 / 12.92, 1e-15);
  EXPECT_NEAR(linear_from_srgb(128), 0.2158605, 1e-7);
  EXPECT_NEAR(linear_from_srgb(255), 1, 1e-15);
}

TEST(Material, OfAMetalReflectsItsColourAndScattersNothing) {
  scene::Look look;
  look.color = Color{255, 128, 0};
  look.metallic = 1;
  look.roughness = 0.3;
  const Material metal = material(look);
  EXPECT_EQ(metal.diffuse, glm::vec3(0));
  EXPECT_NEAR(metal.reflectance.x, 1, 1e-6);
  EXPECT_NEAR(metal.reflectance.y, 0.2158605, 1e-6);
  EXPECT_EQ(metal.reflectance.z, 0);
  EXPECT_NEAR(metal.roughness, 0.3, 1e-6);
  EXPECT_GT(metal.brushing, 0.1F);
}

TEST(Material, OfADielectricScattersItsColourAndReflectsFourPercent) {
  scene::Look look;
  look.color = Color{255, 128, 0};
  look.metallic = 0;
  const Material plastic = material(look);
  EXPECT_NEAR(plastic.diffuse.y, 0.2158605, 1e-6);
  EXPECT_NEAR(plastic.reflectance.x, 0.04, 1e-6);
  EXPECT_NEAR(plastic.reflectance.z, 0.04, 1e-6);
  EXPECT_EQ(plastic.brushing, 0);
}

TEST(Material, IsRockIfAllItsValuesAreThoseOfRock) {
  scene::Look look;
  EXPECT_FALSE(material(look).is_rock);
  scene::set_material(look, scene::find_material("rock", "material"));
  EXPECT_TRUE(material(look).is_rock);
  EXPECT_TRUE(material(look, {}, true).is_rock) << "whatever the colours of its vertices";
  scene::PartLook part;
  part.roughness = 0.5;
  EXPECT_FALSE(material(look, part).is_rock);
}

// Unless set otherwise, a coloured model looks like painted plastic, not like metal.
TEST(Material, OfAPartWithColoursOfItsOwnIsPlasticUnlessSetOtherwise) {
  scene::Look look;
  EXPECT_EQ(material(look).metalness, 1);
  EXPECT_EQ(material(look, {}, true).metalness, 0);
  EXPECT_FLOAT_EQ(material(look, {}, true).roughness, 0.35F);
  look.metallic = 0.5;
  EXPECT_EQ(material(look, {}, true).metalness, 0.5F);
  scene::PartLook part;
  part.metallic = 1;
  part.roughness = 0.2;
  EXPECT_EQ(material(look, part, true).metalness, 1);
  EXPECT_FLOAT_EQ(material(look, part, true).roughness, 0.2F);
}

}  // namespace
}  // namespace twrench::picture
