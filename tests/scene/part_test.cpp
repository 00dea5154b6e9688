// The [[part]] tables of a scene file: shapes, mass, placement and look.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "scene/materials.h"
#include "scene/scene.h"
#include "scene/scene_json.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using testing::HasSubstr;

Body read(const std::string& part) {
  return parse_scene("[[part]]\n" + part + "\n", "some.toml").body;
}

std::string refused(const std::string& part) {
  try {
    read(part);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Part, HasEveryShape) {
  const auto shape = [](const std::string& text) {
    return read(text + "\ndensity = 2").parts[0].shape;
  };
  const auto cone = std::get<body::Cone>(shape("shape = 'cone'\nradius = 3\nlength = 5"));
  EXPECT_EQ(cone.radius, 3);
  EXPECT_EQ(cone.length, 5);
  EXPECT_EQ(cone.top_radius, 0);
  EXPECT_EQ(std::get<body::Cone>(shape("shape = 'cone'\nradius = 3\nlength = 5\ntop_radius = 4"))
                .top_radius,
            4);
  const auto torus = std::get<body::Torus>(shape("shape = 'torus'\nradius = 3\ntube_radius = 1"));
  EXPECT_EQ(torus.radius, 3);
  EXPECT_EQ(torus.tube_radius, 1);
  const auto capsule = std::get<body::Capsule>(shape("shape = 'capsule'\nradius = 3\nlength = 5"));
  EXPECT_EQ(capsule.radius, 3);
  EXPECT_EQ(capsule.length, 5);
  const auto tube =
      std::get<body::Tube>(shape("shape = 'tube'\nradius = 3\ninner_radius = 2\nlength = 5"));
  EXPECT_EQ(tube.radius, 3);
  EXPECT_EQ(tube.inner_radius, 2);
  EXPECT_EQ(tube.length, 5);
  EXPECT_EQ(std::get<body::Ellipsoid>(shape("shape = 'sphere'\nradius = 3")).radii,
            Vector3d(3, 3, 3));
}

// The JSON of a scene has the keys of its file.
TEST(Part, IsTheSameFromItsJson) {
  for (const char* shape :
       {"shape = 'cylinder'\nradius = 3\nlength = 5", "shape = 'box'\nsize = [1, 2, 3]",
        "shape = 'ellipsoid'\nradii = [1, 2, 3]",
        "shape = 'cone'\nradius = 3\nlength = 5\ntop_radius = 4",
        "shape = 'torus'\nradius = 3\ntube_radius = 1", "shape = 'capsule'\nradius = 3\nlength = 5",
        "shape = 'tube'\nradius = 3\ninner_radius = 2\nlength = 5"}) {
    const std::string text = fmt::format(
        "[[part]]\n{}\nmass = 7\nname = 'it'\nmaterial = 'brass'\nroughness = 0.5\n"
        "position = [1, 2, 3]\nrotation = [0.1, 0.2, 0.3]\n",
        shape);
    const Scene scene = parse_scene(text, "some.toml");
    const auto json = scene_json(scene)["part"][0];
    std::string again = "[[part]]\n";
    for (const auto& [key, value] : json.items()) again += key + " = " + value.dump() + "\n";
    EXPECT_EQ(scene_json(parse_scene(again, "some.toml"))["part"][0], json) << again;
    EXPECT_EQ(json["color"], "#f4e4ad");
    EXPECT_EQ(json["metallic"], 1);
    EXPECT_EQ(json["roughness"], 0.5);
  }
}

TEST(Part, MayHaveItsMassInPlaceOfItsDensity) {
  const std::string box = "shape = 'box'\nsize = [1, 2, 3]\n";
  EXPECT_EQ(read(box + "mass = 12").parts[0].density, 2);
  const Body tube = read("shape = 'tube'\nradius = 3\ninner_radius = 2\nlength = 5\nmass = 100");
  EXPECT_NEAR(tube.parts[0].density, 100 / (pi * 25), 1e-14);
  EXPECT_NEAR(mass_properties(tube).mass, 100, 1e-13);
  EXPECT_THAT(refused(box + "mass = 12\ndensity = 1"),
              HasSubstr("some.toml:4: part[0].mass: cannot be combined with density"));
  EXPECT_THAT(refused(box), HasSubstr("some.toml:1: part[0].density: is missing"));
  EXPECT_THAT(refused(box + "mass = 0"), HasSubstr("some.toml:4: part[0].mass: is 0"));
  EXPECT_THAT(refused(box + "mass = -1"), HasSubstr("some.toml:4: part[0].mass: is -1"));
  EXPECT_THAT(refused(box + "mass = 1e8"),
              HasSubstr("some.toml:4: part[0].mass: is 100000000 g, which makes the density "
                        "1.66667e+07 g/cm^3, but that must be at least 1e-09"));
}

TEST(Part, OfADimensionThatNoSolidHasIsRefused) {
  EXPECT_THAT(
      refused("shape = 'torus'\nradius = 1\ntube_radius = 1\ndensity = 1"),
      HasSubstr("some.toml:4: part[0].tube_radius: is 1, but must be less than the radius, 1"));
  EXPECT_THAT(refused("shape = 'tube'\nradius = 1\nlength = 2\ninner_radius = 1.5\ndensity = 1"),
              HasSubstr("some.toml:5: part[0].inner_radius: is 1.5, but must be less than"));
  EXPECT_THAT(refused("shape = 'tube'\nradius = 1\nlength = 2\ninner_radius = 0\ndensity = 1"),
              HasSubstr("some.toml:5: part[0].inner_radius: is 0"));
  EXPECT_THAT(refused("shape = 'cone'\nradius = 0\nlength = 2\ndensity = 1"),
              HasSubstr("some.toml:3: part[0].radius: is 0"));
  EXPECT_THAT(refused("shape = 'cone'\nradius = 1\nlength = 2\ntop_radius = -1\ndensity = 1"),
              HasSubstr("some.toml:5: part[0].top_radius: is -1"));
  EXPECT_THAT(refused("shape = 'capsule'\nradius = 1\ndensity = 1"),
              HasSubstr("some.toml:1: part[0].length: is missing"));
  EXPECT_THAT(refused("shape = 'capsule'\nradius = 1\nlength = 2\ndensity = 1\ncrease = 1"),
              HasSubstr("some.toml:6: part[0]: unknown name 'crease'"));
  EXPECT_THAT(refused("shape = 'tours'\nradius = 1"), HasSubstr("some.toml:2: part[0].shape"));
}

TEST(Part, HasItsOwnLook) {
  const std::string sphere = "shape = 'sphere'\nradius = 1\ndensity = 1\n";
  const auto look = [&](const std::string& text) {
    return description(read(sphere + text), 0).look;
  };
  EXPECT_FALSE(look("").color);
  EXPECT_FALSE(look("").metallic);
  EXPECT_FALSE(look("").roughness);
  EXPECT_EQ(look("color = '#102030'").color, (Color{16, 32, 48}));
  EXPECT_FALSE(look("color = '#102030'").metallic);
  const Material wood = find_material("wood", "");
  EXPECT_EQ(look("material = 'wood'").color, wood.color);
  EXPECT_EQ(look("material = 'wood'").metallic, 0);
  EXPECT_EQ(look("material = 'wood'").roughness, wood.roughness);
  // The order of the keys does not matter.
  EXPECT_EQ(look("color = '#102030'\nmaterial = 'wood'").color, (Color{16, 32, 48}));
  EXPECT_EQ(look("metallic = 0.5\nmaterial = 'wood'\nroughness = 0.1").roughness, 0.1);
  EXPECT_EQ(look("metallic = 0.5\nmaterial = 'wood'\nroughness = 0.1").color, wood.color);
  EXPECT_THAT(refused(sphere + "material = 'bras'"),
              HasSubstr("some.toml:5: part[0].material: unknown name 'bras'"));
  EXPECT_THAT(refused(sphere + "color = 'pink'"), HasSubstr("some.toml:5: part[0].color: 'pink'"));
  EXPECT_THAT(refused(sphere + "metallic = 2"), HasSubstr("some.toml:5: part[0].metallic: is 2"));
  EXPECT_THAT(refused(sphere + "roughness = 0"), HasSubstr("some.toml:5: part[0].roughness: is 0"));
}

}  // namespace
}  // namespace twrench::scene
