// Each picture option sets the scene value it is named after, as recorded in the manifest.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/twrench.h"
#include "image/png.h"

namespace twrench {
namespace {

using nlohmann::json;

/// The scene of one small frame drawn with these options.
json scene_drawn_with(const std::string& options) {
  const ScratchFolder folder;
  const Outcome run =
      run_twrench(folder, "render --size 64x36 --frames 0 --no-video --progress none " + options);
  EXPECT_EQ(run.code, 0) << run.err;
  if (run.code != 0) return {};
  return json::parse(text_of(folder / "out/dzhanibekov/manifest.json"))["scene"];
}

TEST(PictureOptions, OfTheCamera) {
  const json scene = scene_drawn_with(
      "--azimuth 0.5 --elevation 0.25 --distance 1.5 --orbit 0.125 --field-of-view 0.75 "
      "--frame rotating");
  EXPECT_EQ(scene["camera"], json({{"azimuth", 0.5},
                                   {"elevation", 0.25},
                                   {"distance", 1.5},
                                   {"orbit", 0.125},
                                   {"field_of_view", 0.75},
                                   {"frame", "rotating"}}));
}

TEST(PictureOptions, OfTheLook) {
  const json scene = scene_drawn_with(
      "--theme paper --samples 2 --motion-blur 3 --background '#102030' --color '#405060' "
      "--metallic 0.25 --roughness 0.75");
  EXPECT_EQ(scene["look"], json({{"theme", "paper"},
                                 {"samples", 2},
                                 {"motion_blur", 3},
                                 {"background", "#102030"},
                                 {"color", "#405060"},
                                 {"metallic", 0.25},
                                 {"roughness", 0.75}}));
}

TEST(PictureOptions, OfTheMaterial) {
  const json brass = scene_drawn_with("--material brass")["look"];
  EXPECT_EQ(brass["material"], "brass");
  EXPECT_EQ(brass["color"], "#f4e4ad");
  const json wood = scene_drawn_with("--roughness 0.75 --material wood")["look"];
  EXPECT_FALSE(wood.contains("material"));
  EXPECT_EQ(wood["metallic"], 0);
  EXPECT_EQ(wood["roughness"], 0.75);
}

// A wide lobe that misses a thin neighbour must not reflect more of it than one that hits it. The
// balls differ, so that the body has no white mark.
TEST(PictureOptions, RoughPaintBesideAThinPartIsDull) {
  const ScratchFolder folder;
  std::ofstream(folder / "disc.toml") << R"(
    part = [
      {shape = "cylinder", radius = 4, length = 0.24, density = 0.25},
      {shape = "sphere", radius = 0.75, position = [4, 0, 0], density = 19},
      {shape = "sphere", radius = 0.75, position = [-4, 0, 0], density = 19},
      {shape = "sphere", radius = 0.5, position = [0, 4, 0], density = 19},
      {shape = "sphere", radius = 0.4, position = [0, -4, 0], density = 19},
    ]
    motion = {omega = [0, 1, 0.01], duration = 48}
    film = {speed = 3}
    camera = {azimuth = 0.35, elevation = 0.2, frame = "rotating"}
  )";
  const Outcome run = run_twrench(
      folder,
      "render disc.toml --size 160x120 --frames 100 --bare --metallic 0 --roughness 0.9 --color "
      "gray --no-video --progress none --frames-dir f");
  ASSERT_EQ(run.code, 0) << run.err;
  const image::Image picture = image::read_png(folder / "f/frame_000100.png");
  EXPECT_LT(*std::ranges::max_element(picture.pixels), 200);
}

TEST(PictureOptions, OfTheOverlay) {
  const json scene = scene_drawn_with(
      "--title Wrench --bare --show trail,plane,omega --hide plane --trail-point 1,2,3 "
      "--trail-length 4 --star-trail 1.5 --font mono");
  EXPECT_EQ(scene["title"], "Wrench");
  EXPECT_EQ(scene["overlay"], json({{"view", "wrench"},
                                    {"show", {"omega", "trail"}},
                                    {"trail_point", {1.0, 2.0, 3.0}},
                                    {"trail_length", 4.0},
                                    {"star_trail", 1.5},
                                    {"font", "mono"}}));
}

TEST(PictureOptions, OfWhatIsSeen) {
  EXPECT_EQ(scene_drawn_with("--view momentum")["overlay"]["view"], "momentum");
  EXPECT_EQ(scene_drawn_with("--compare rk4,exact")["overlay"]["compare"], json({"rk4", "exact"}));
}

}  // namespace
}  // namespace twrench
