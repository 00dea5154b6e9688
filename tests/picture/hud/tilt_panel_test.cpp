#include "picture/hud/tilt_panel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

scene::Scene with_tilt(const Eigen::Vector3d& omega, int width = 1280, int height = 720) {
  scene::Scene scene = film_of(width, height);
  scene.overlay.show.insert(scene::Feature::tilt);
  scene.motion.method = "exact";
  scene.motion.omega = omega;
  return scene;
}

TiltPanel tilt_panel_of(const OverlayScene& all) {
  return {all.scene, all.timeline.solutions(), all.layout, all.typeface, all.colors};
}

TEST(TiltPanel, MakesExponentialGrowthAStraightLine) {
  const OverlayScene all(with_tilt({1, 1e-4, 0}));
  const TiltPanel panel = tilt_panel_of(all);
  const auto a = panel.place(5, 1e-4), b = panel.place(10, 1e-3), c = panel.place(15, 1e-2);
  EXPECT_NEAR(b.x - a.x, c.x - b.x, 1e-9);
  EXPECT_NEAR(a.y - b.y, b.y - c.y, 1e-9);
  EXPECT_GT(a.y, b.y);
}

TEST(TiltPanel, HoldsTheWholeCurve) {
  for (const Eigen::Vector3d& omega :
       {Eigen::Vector3d(1, 0.05, 0), {1, 1e-7, 0}, {0, 1, 0.05}, {0, 0, 1}, {0, 0, 0}}) {
    const OverlayScene all(with_tilt(omega));
    const TiltPanel panel = tilt_panel_of(all);
    const motion::Tilt tilt(all.timeline.solutions()[0].body);
    const image::Area& area = *all.layout.tilt;
    for (const motion::Sample& sample : all.timeline.solutions()[0].whole) {
      const auto [x, y] = panel.place(sample.t, tilt.of(sample));
      ASSERT_TRUE(x >= area.x && x <= area.x + area.width) << x;
      ASSERT_TRUE(y >= area.y && y <= area.y + area.height) << y;
    }
  }
}

TEST(TiltPanel, DrawsThePredictionOfAnUnstableAxisOnly) {
  // It is yellow; everything else is gray.
  const auto dashes = [](const Eigen::Vector3d& omega) {
    const OverlayScene all(with_tilt(omega));
    TiltPanel panel = tilt_panel_of(all);
    int count = 0;
    for (const Layer& layer : panel.draw(all.timeline.frame_state(0))) {
      for (std::size_t i = 0; i < layer.image.pixels.size(); i += 4) {
        const std::uint8_t* p = &layer.image.pixels[i];
        count += p[0] > p[2] + 60 ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_GT(dashes({1, 0.05, 0}), 20);
  EXPECT_EQ(dashes({0, 1, 0.05}), 0);
  EXPECT_EQ(dashes({0, 0, 0}), 0);
}

TEST(TiltPanel, ShowsThePastInFullStrength) {
  const OverlayScene start(with_tilt({1, 0.05, 0}), 0), end(with_tilt({1, 0.05, 0}), 959);
  TiltPanel first = tilt_panel_of(start), last = tilt_panel_of(end);
  const auto bright = [](Element& panel, const timeline::FrameState& state) {
    int count = 0;
    for (const Layer& layer : panel.draw(state)) {
      for (std::size_t i = 0; i < layer.image.pixels.size(); i += 4) {
        count += layer.image.pixels[i] > 230 ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_GT(bright(last, end.timeline.frame_state(0)),
            bright(first, start.timeline.frame_state(0)) + 200);
}

TEST(TiltPanel, IsDrawnInPicturesOfAnySize) {
  for (const auto& [width, height] :
       {std::pair(1920, 1080), {1080, 1920}, {320, 180}, {200, 1600}}) {
    const OverlayScene all(with_tilt({1, 0.05, 0}, width, height));
    if (!all.layout.tilt) continue;
    TiltPanel panel = tilt_panel_of(all);
    EXPECT_EQ(panel.draw(all.timeline.frame_state(0)).size(), 1U) << width;
  }
}

}  // namespace
}  // namespace twrench::picture
