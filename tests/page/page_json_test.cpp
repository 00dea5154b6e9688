#include "page/page_json.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <numbers>
#include <string_view>
#include <vector>

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

std::vector<std::uint8_t> bytes_of(const std::string& base64) {
  static constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count)));
  }
  return bytes;
}

/// The integers, on a processor that is little-endian.
template <typename Integer>
std::vector<Integer> unpacked(const std::string& base64) {
  const std::vector<std::uint8_t> bytes = bytes_of(base64);
  std::vector<Integer> integers(bytes.size() / sizeof(Integer));
  std::memcpy(integers.data(), bytes.data(), integers.size() * sizeof(Integer));
  return integers;
}

/// The volume in cm^3 that the surface encloses, positive if its triangles face outwards.
double volume_within(const ordered_json& surface) {
  const auto vertices = unpacked<std::int16_t>(surface.at("vertices"));
  const auto indices = unpacked<std::uint16_t>(surface.at("indices"));
  const double unit = surface.at("radius").get<double>() / 32767;
  const auto vector = [&](std::size_t at) {
    return Vector3d(vertices.at(at), vertices.at(at + 1), vertices.at(at + 2));
  };
  double volume = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    std::array<Vector3d, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = 6 * std::size_t{indices[i + k]};
      corner[k] = unit * vector(vertex);
      EXPECT_NEAR(vector(vertex + 3).norm() / 32767, 1, 1e-4);
    }
    volume += corner[0].dot(corner[1].cross(corner[2])) / 6;
  }
  return volume;
}

TEST(PageJson, HoldsTheSurfaceOfTheBody) {
  const ordered_json surface = page_json(scene::load_scene("sphere")).at("surface");
  EXPECT_DOUBLE_EQ(surface.at("radius"), 1);
  EXPECT_NEAR(volume_within(surface), 4 * std::numbers::pi / 3, 0.01);
  EXPECT_TRUE(surface.at("marked"));
  ASSERT_EQ(surface.at("parts").size(), 1U);
  EXPECT_EQ(surface["parts"][0]["end"], unpacked<std::uint16_t>(surface.at("indices")).size());
}

TEST(PageJson, TellsWhichPartsTouch) {
  const ordered_json surface = page_json(scene::load_scene("dzhanibekov")).at("surface");
  const ordered_json& leg = surface.at("parts").at(1);
  ASSERT_EQ(leg.at("occluders").size(), 1U);
  EXPECT_TRUE(leg["occluders"][0].at("meets"));
  EXPECT_LT(leg.at("side_begin"), leg.at("end"));
  EXPECT_FALSE(surface.at("marked"));
}

TEST(PageJson, KeepsThePageSmall) {
  for (const std::string& name : scene::builtin_scene_names()) {
    const ordered_json surface = page_json(scene::load_scene(name)).at("surface");
    // A page has at most 600 kB for the default scene, of which all else takes 330.
    EXPECT_LT(surface.dump().size(), name == "dzhanibekov" ? 100'000U : 350'000U) << name;
  }
}

TEST(PageJson, HoldsTheInertiaRowByRow) {
  const scene::Scene scene = scene::load_scene("dzhanibekov");
  const Eigen::Matrix3d inertia = scene::mass_properties(scene.body).inertia;
  const auto numbers = page_json(scene).at("inertia").get<std::vector<double>>();
  ASSERT_EQ(numbers.size(), 9U);
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      EXPECT_EQ(numbers[static_cast<std::size_t>(3 * row + column)], inertia(row, column));
    }
  }
}

TEST(PageJson, GivesEachThemeTheLookOfTheScene) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  for (const double metallic : {0.0, 1.0}) {
    scene.look.metallic = metallic;
    const ordered_json themes = page_json(scene).at("themes");
    for (const char* const name : {"studio", "paper", "space"}) {
      const ordered_json& theme = themes.at(name);
      const ordered_json& material = theme.at("materials").at(0);
      EXPECT_EQ(material.at("metal"), metallic == 1);
      EXPECT_NE(material.at("constants").get<std::string>().find("light_radiance"),
                std::string::npos);
      EXPECT_EQ(theme.at("floor").is_null(), std::string_view(name) == "space");
      EXPECT_EQ(theme.at("overlay").at("curve").size(), 9U);
    }
  }
}

TEST(PageJson, LeavesOutTheShotsOfAStory) {
  const scene::Scene story = scene::load_scene("explain");
  ASSERT_FALSE(story.shots.empty());
  EXPECT_FALSE(page_json(story).at("scene").contains("shot"));
}

}  // namespace
}  // namespace twrench::page
