#include "scene/materials.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scene/fields.h"
#include "scene/limits.h"
#include "scene/scene.h"
#include "scene/scene_json.h"
#include "scene/scene_values.h"

namespace twrench::scene {
namespace {

Look look_of(const std::string& keys) {
  return parse_scene("[body]\nmoments = [1, 2, 3]\n[look]\n" + keys, "some.toml").look;
}

TEST(Materials, AreAllowedAndNoTwoLookAlike) {
  EXPECT_THAT(material_names(),
              testing::ElementsAre("steel", "brass", "wood", "plastic", "rubber", "rock", "paper"));
  for (const Material& material : materials()) {
    EXPECT_TRUE(limits::fraction.allows(material.metallic));
    EXPECT_TRUE(limits::roughness.allows(material.roughness));
    Look look;
    set_material(look, material);
    EXPECT_EQ(material_name(look), material.name);
  }
}

TEST(Materials, AreInTheDocument) {
  std::ifstream file(TWRENCH_TESTS_DIR "/../docs/scene-files.md");
  std::ostringstream text;
  text << file.rdbuf();
  for (const auto& [name, color, metallic, roughness] : materials()) {
    EXPECT_THAT(text.str(), testing::HasSubstr(fmt::format("| `{}` | `{}` | {} | {} |", name,
                                                           to_string(color), metallic, roughness)));
  }
}

TEST(Materials, OfTheWholeBodyGiveWayToExplicitValues) {
  const Material rubber = find_material("rubber", "");
  EXPECT_EQ(look_of("material = 'rubber'").color, rubber.color);
  EXPECT_EQ(look_of("material = 'rubber'").metallic, rubber.metallic);
  const Look look = look_of("roughness = 0.3\nmaterial = 'rubber'\n");
  EXPECT_EQ(look.roughness, 0.3);
  EXPECT_EQ(look.color, rubber.color);
  EXPECT_EQ(material_name(look), std::nullopt);
  EXPECT_THROW(look_of("material = 'ruber'"), InvalidArgument);
}

TEST(Materials, AreInTheScenesJson) {
  Scene scene = load_scene("dzhanibekov");
  EXPECT_FALSE(scene_json(scene)["look"].contains("material"));
  set_value(scene, "material", "brass");
  EXPECT_EQ(scene_json(scene)["look"]["material"], "brass");
  EXPECT_EQ(scene_json(scene)["look"]["color"], "#f4e4ad");
  set_value(scene, "color", "#112233");
  EXPECT_FALSE(scene_json(scene)["look"].contains("material"));
  EXPECT_EQ(scene_json(scene)["look"]["metallic"], 1);
}

}  // namespace
}  // namespace twrench::scene
