#include "picture/hud/force_legend.h"

#include <gtest/gtest.h>

#include "base/enumeration.h"
#include "picture/look/force_style.h"
#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

scene::Scene with_forces(int width, int height, scene::Frame frame) {
  scene::Scene scene = film_of(width, height);
  scene.overlay.show.insert(scene::Feature::forces);
  scene.camera.frame = frame;
  return scene;
}

std::vector<Layer> legend_of(const OverlayScene& all) {
  const TextStyle style{all.typeface, all.colors, all.layout.text, all.layout.compact, false};
  ForceLegend legend(all.scene, all.layout, style);
  return legend.draw(all.timeline.frame_state(0));
}

bool has(const Layer& layer, const Color& color) {
  for (std::size_t i = 0; i < layer.image.pixels.size(); i += 4) {
    const std::uint8_t* p = &layer.image.pixels[i];
    if (p[0] == color.red && p[1] == color.green && p[2] == color.blue) return true;
  }
  return false;
}

TEST(ForceLegend, HasTheColoursOfTheForcesInTheFrameAndNoOther) {
  for (const auto& [frame, other] :
       {std::pair(scene::Frame::rotating, Force::euler), {scene::Frame::body, Force::coriolis}}) {
    const OverlayScene all(with_forces(1280, 720, frame));
    const auto layers = legend_of(all);
    ASSERT_EQ(layers.size(), 1U);
    for (const Force force : forces_in(frame)) {
      EXPECT_TRUE(has(layers[0], color_of(force, all.colors))) << enumerator_name(force);
    }
    EXPECT_FALSE(has(layers[0], color_of(other, all.colors)));
  }
}

TEST(ForceLegend, HasTheColoursOfTheForcesOnTheTip) {
  scene::Scene scene = film_of(1280, 720);
  scene.overlay.show = {scene::Feature::tip};
  scene.camera.frame = scene::Frame::rotating;
  const OverlayScene all(scene);
  const auto layers = legend_of(all);
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_TRUE(has(layers[0], color_of(Force::centrifugal, all.colors)));
  EXPECT_TRUE(has(layers[0], color_of(Force::coriolis, all.colors)));
  EXPECT_TRUE(has(layers[0], color_of(Force::sum, all.colors)));
  EXPECT_FALSE(has(layers[0], color_of(Force::constraint, all.colors)));
}

TEST(ForceLegend, HasOnlyTheForcesThatTheSceneShows) {
  scene::Scene scene = film_of(1280, 720);
  scene.overlay.show = {scene::Feature::tip};
  scene.overlay.forces = {Force::coriolis, Force::euler};
  scene.camera.frame = scene::Frame::rotating;
  const OverlayScene all(scene);
  const auto layers = legend_of(all);
  ASSERT_EQ(layers.size(), 1U);
  EXPECT_TRUE(has(layers[0], color_of(Force::coriolis, all.colors)));
  EXPECT_FALSE(has(layers[0], color_of(Force::centrifugal, all.colors)));
}

TEST(ForceLegend, StaysInItsRow) {
  for (const auto& [width, height] :
       {std::pair(1920, 1080), {1080, 1920}, {640, 360}, {320, 180}}) {
    const OverlayScene all(with_forces(width, height, scene::Frame::rotating));
    if (!all.layout.forces) continue;
    const auto feather = static_cast<int>(std::ceil(2.2 * all.layout.text.caption));
    for (const Layer& layer : legend_of(all)) {
      EXPECT_LE(layer.image.width, all.layout.forces->width + 2 * feather) << width;
      EXPECT_LE(layer.image.height, all.layout.forces->height + 2 * feather) << width;
    }
  }
}

}  // namespace
}  // namespace twrench::picture
