#include "picture/hud/tilt_panel.h"

#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <algorithm>
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

/// Returns whether a layer shows something brighter than that in a column of the panel's plot.
int bright_columns(const std::vector<Layer>& layers, int from_x) {
  int columns = 0;
  for (const Layer& layer : layers) {
    for (int x = std::max(0, from_x - layer.x); x < layer.image.width; ++x) {
      bool bright = false;
      for (int y = layer.image.height / 2; y < layer.image.height; ++y) {
        const std::size_t pixel = static_cast<std::size_t>(y * layer.image.width + x);
        bright = bright || layer.image.pixels[4 * pixel + 2] > 150;
      }
      columns += bright ? 1 : 0;
    }
  }
  return columns;
}

TEST(TiltPanel, DrawsNothingOfTheFutureButThePrediction) {
  const OverlayScene early(with_tilt({1, 1e-4, 0}), 100), late(with_tilt({1, 1e-4, 0}), 450);
  TiltPanel panel = tilt_panel_of(early);
  const auto now = [&](const OverlayScene& all) {
    return panel.place(all.timeline.frame_state(0).solutions[0].sample.t, 1e-3).x;
  };
  const int after = static_cast<int>(now(early)) + 30;  // beside the mark
  ASSERT_GT(now(late), after + 12);
  EXPECT_EQ(bright_columns(panel.draw(early.timeline.frame_state(0)), after), 0);
  EXPECT_GT(bright_columns(panel.draw(late.timeline.frame_state(0)), after), 12);
}

TEST(TiltPanel, MarksEachDoubling) {
  scene::Scene scene = with_tilt({1, 0.001, 0}, 1920, 1080);
  scene.motion.duration = 20;
  const OverlayScene all(scene);
  const TiltPanel panel = tilt_panel_of(all);
  const motion::FreeBody body = all.timeline.solutions()[0].body;
  const motion::Tilt tilt(body);
  const double start = tilt.of(motion::ExactMotion(body).at(0));
  ASSERT_GE(panel.marks().size(), 6U);
  for (std::size_t i = 0; i < panel.marks().size(); ++i) {
    const auto [time, value] = panel.marks()[i];
    EXPECT_DOUBLE_EQ(value, start * std::exp2(i + 1));
    EXPECT_NEAR(tilt.of(motion::ExactMotion(body).at(time)) / value, 1, 1e-3);
  }
  const double doubling = std::numbers::ln2 / tilt.growth()->rate;
  EXPECT_NEAR(panel.marks()[5].time - panel.marks()[4].time, doubling, 0.02 * doubling);
}

TEST(TiltPanel, MarksFactorsOfTenWhereDoublingsAreTooDense) {
  scene::Scene scene = with_tilt({1, 1e-8, 0}, 640, 360);
  const OverlayScene all(scene);
  ASSERT_TRUE(all.layout.tilt);
  const TiltPanel panel = tilt_panel_of(all);
  ASSERT_GE(panel.marks().size(), 6U);
  EXPECT_NEAR(panel.marks()[3].tilt / panel.marks()[2].tilt, 10, 1e-9);
}

TEST(TiltPanel, MarksNothingIfTheTiltDoesNotGrow) {
  for (const Eigen::Vector3d& omega : {Eigen::Vector3d(0, 0, 1), {0, 0, 0}}) {
    const OverlayScene all(with_tilt(omega));
    EXPECT_TRUE(tilt_panel_of(all).marks().empty());
  }
}

TEST(TiltPanel, ShowsANumberThatRoundOffDoesNotChange) {
  const OverlayScene all(with_tilt({0, 0, 1}));
  TiltPanel panel = tilt_panel_of(all);
  timeline::FrameState state = all.timeline.frame_state(0);
  const motion::FreeBody body = all.timeline.solutions()[0].body;
  const auto picture = [&](double angle) {
    const Eigen::AngleAxisd tilted(angle, Eigen::Vector3d::UnitX());
    state.solutions[0].sample.omega = body.inverse() * (tilted * body.momentum());
    return panel.draw(state)[0].image.pixels;
  };
  EXPECT_EQ(picture(0), picture(1e-15));
  EXPECT_EQ(picture(1e-15), picture(3e-16));
  const double tie = 2.25 / 180 * std::numbers::pi;  // half way from 2.2 to 2.3 degrees
  EXPECT_EQ(picture(tie - 1e-15), picture(tie + 1e-15));
  EXPECT_NE(picture(tie), picture(1.1 * tie));
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
