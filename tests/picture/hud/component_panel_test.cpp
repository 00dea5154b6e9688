#include "picture/hud/component_panel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

scene::Scene film(int width = 1280, int height = 720) {
  scene::Scene scene = film_of(width, height);
  scene.overlay.show = {scene::Feature::components};
  return scene;
}

ComponentPanel panel_of(const OverlayScene& film) {
  return {film.scene, film.timeline.solutions(), film.layout, film.typeface, film.colors};
}

timeline::FrameState at(const OverlayScene& film, double t) {
  timeline::FrameState state = film.timeline.frame_state(0);
  const auto& whole = film.timeline.solutions()[0].whole;
  const double share = t / film.scene.motion.duration;
  state.solutions[0].sample =
      whole[static_cast<std::size_t>(std::lround(share * static_cast<double>(whole.size() - 1)))];
  return state;
}

/// Returns the sum of all colours in the columns of a layer.
double light(const Layer& layer, int first, int last) {
  double sum = 0;
  for (int y = 0; y < layer.image.height; ++y) {
    for (int x = first; x < last; ++x) {
      const auto p =
          static_cast<std::size_t>(y) * layer.image.row_bytes() + 4 * static_cast<std::size_t>(x);
      for (std::size_t c = 0; c < 3; ++c) sum += layer.image.pixels[p + c];
    }
  }
  return sum;
}

TEST(ComponentPanel, BrightensWithTime) {
  const OverlayScene scene(film());
  ComponentPanel panel = panel_of(scene);
  double before = 0;
  for (const double t : {0.0, 24.0, 48.0, 72.0, 96.0}) {
    const Layer layer = panel.draw(at(scene, t)).at(0);
    const double now = light(layer, 0, layer.image.width);
    EXPECT_GT(now, before) << t;
    before = now;
  }
}

TEST(ComponentPanel, ChangesBehindTheCursorOnly) {
  const OverlayScene scene(film());
  ComponentPanel panel = panel_of(scene);
  const Layer early = panel.draw(at(scene, 24)).at(0);
  const Layer late = panel.draw(at(scene, 72)).at(0);
  const image::Area area = *scene.layout.components;
  // The first plot of each row begins at the area's left edge; the past at both times is the same.
  const int plot = area.width / 3;
  const int before = area.x - early.x;
  for (int y = 0; y < early.image.height; ++y) {
    for (int x = before; x < before + plot / 4 - 12; ++x) {
      const auto p =
          static_cast<std::size_t>(y) * early.image.row_bytes() + 4 * static_cast<std::size_t>(x);
      ASSERT_EQ(early.image.pixels[p], late.image.pixels[p]) << x << " " << y;
    }
  }
  EXPECT_FALSE(same({early}, {late}));
}

TEST(ComponentPanel, DrawsTheSameWhateverItDrewBefore) {
  const OverlayScene scene(film());
  ComponentPanel panel = panel_of(scene);
  const auto alone = panel.draw(at(scene, 30));
  panel.draw(at(scene, 90));
  panel.draw(at(scene, 10));
  EXPECT_TRUE(same(panel.draw(at(scene, 30)), alone));
}

TEST(ComponentPanel, PutsTheCursorsDotOnTheCurve) {
  const OverlayScene scene(film());
  ComponentPanel panel = panel_of(scene);
  timeline::FrameState state = at(scene, 48);
  const auto drawn = panel.draw(state);
  state.solutions[0].sample.X.row(0).swap(state.solutions[0].sample.X.row(1));
  EXPECT_FALSE(same(panel.draw(state), drawn)) << "it follows the sample of the state";
}

TEST(ComponentPanel, StaysInThePictureWithAMethodThatLeavesTheRotations) {
  scene::Scene scene = film(1280, 720);
  scene.overlay.compare = {"euler", "exact"};
  scene.motion.control.step = 0.2;
  const OverlayScene comparison(scene);
  ComponentPanel panel = panel_of(comparison);
  timeline::FrameState state = comparison.timeline.frame_state(0);
  state.solutions[0].sample.X *= 1e9;
  const Layer layer = panel.draw(state).at(0);
  EXPECT_LE(layer.y + layer.image.height, 720);
  EXPECT_LE(layer.x + layer.image.width, 1280);
}

TEST(ComponentPanel, FitsWhateverAreaItIsGiven) {
  const image::Area picture{0, 0, 200, 100};
  OverlayScene small(film(picture.width, picture.height));
  for (const image::Area& area : {image::Area{10, 5, 180, 90},
                                  {90, 45, 12, 8},
                                  {0, 0, 1, 1},
                                  {199, 99, 1, 1},
                                  {0, 0, 200, 100},
                                  {0, 40, 200, 9}}) {
    small.layout.components = area;
    ComponentPanel panel = panel_of(small);
    for (const Layer& layer : panel.draw(at(small, 48))) {
      EXPECT_EQ(image::common(layer.area(), picture), layer.area()) << area.x << " " << area.y;
    }
  }
}

// No layout produces such an area. Without the cut, memory would be overwritten.
TEST(ComponentPanel, IsCutOffAtThePicturesEdges) {
  const image::Area picture{0, 0, 200, 100};
  OverlayScene small(film(picture.width, picture.height));
  for (const image::Area& area : {image::Area{20, -30, 180, 160},
                                  {-40, 10, 120, 80},
                                  {150, 10, 120, 80},
                                  {20, 20, 160, 200},
                                  {300, 20, 160, 80},
                                  {-20, -20, 240, 140}}) {
    small.layout.components = area;
    ComponentPanel panel = panel_of(small);
    for (const Layer& layer : panel.draw(at(small, 96))) {
      EXPECT_EQ(image::common(layer.area(), picture), layer.area()) << area.x << " " << area.y;
    }
  }
}

}  // namespace
}  // namespace twrench::picture
