#include "picture/hud/angle_panel.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <string>
#include <utility>
#include <vector>

#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

TEST(AngleScale, IsLogarithmic) {
  const AngleScale scale{1e-3 * degree, 10 * degree, {50, 20, 300, 80}, 10};
  EXPECT_DOUBLE_EQ(scale.y(10 * degree), 20);
  EXPECT_DOUBLE_EQ(scale.y(0.1 * degree), 60);
  EXPECT_DOUBLE_EQ(scale.y(1e-3 * degree), 100);
  EXPECT_DOUBLE_EQ(scale.y(0), 100);
  EXPECT_DOUBLE_EQ(scale.y(1), 20);
  EXPECT_DOUBLE_EQ(decade_below(0.3 * degree), 0.1 * degree);
  EXPECT_DOUBLE_EQ(decade_below(0.1 * degree), 0.1 * degree);
}

scene::Scene comparison(const std::vector<std::string>& methods) {
  scene::Scene scene = film_of(1280, 720);
  scene.overlay.compare = methods;
  scene.motion.control.step = 0.1;
  return scene;
}

std::vector<Layer> drawn_angle(const OverlayScene& film, const timeline::FrameState& state) {
  AnglePanel panel(film.scene, film.timeline.solutions(), film.layout, film.typeface, film.colors);
  return panel.draw(state);
}

TEST(AnglePanel, ShowsAnglesAndNoAttitudes) {
  const OverlayScene film(comparison({"rk4", "exact"}), 300);
  timeline::FrameState state = film.timeline.frame_state(0);
  const auto before = drawn_angle(film, state);
  const Eigen::Matrix3d turn = so3::exp(Eigen::Vector3d(0.3, -1, 0.2));
  for (timeline::SolutionState& solution : state.solutions) {
    solution.sample.X = turn * solution.sample.X;
  }
  EXPECT_TRUE(same(drawn_angle(film, state), before));
  state.solutions[0].sample.X *= turn;
  EXPECT_FALSE(same(drawn_angle(film, state), before));
}

/// Whether the angles are those from this motion: then it does not matter how the two others differ
/// from each other.
bool are_from(const OverlayScene& film, std::size_t reference) {
  timeline::FrameState state = film.timeline.frame_state(0);
  const auto drawn = [&](const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
    state.solutions[reference].sample.X.setIdentity();
    state.solutions[(reference + 1) % 3].sample.X = so3::exp(one);
    state.solutions[(reference + 2) % 3].sample.X = so3::exp(other);
    return drawn_angle(film, state);
  };
  return same(drawn({1, 0, 0}, {1, 0, 0}), drawn({1, 0, 0}, {0, 1, 0}));
}

TEST(AnglePanel, IsAgainstTheExactMotionOrTheFirst) {
  EXPECT_TRUE(are_from(OverlayScene(comparison({"rk4", "euler", "exact"}), 300), 2));
  EXPECT_FALSE(are_from(OverlayScene(comparison({"rk4", "euler", "exact"}), 300), 0));
  EXPECT_TRUE(are_from(OverlayScene(comparison({"rk4", "euler", "rkmk4"}), 300), 0));
}

TEST(Layout, ShowsAnglesBesideTheCurveOfAComparison) {
  const Layout layout = compute_layout(comparison({"rk4", "exact"}));
  ASSERT_TRUE(layout.curve && layout.angle);
  EXPECT_EQ(layout.angle->width, layout.curve->width);
  scene::Scene starts = film_of(1280, 720);
  starts.overlay.compare_omega = {{0, 1, 0}, {1, 0, 0}};
  EXPECT_FALSE(compute_layout(starts).angle);  // other motions are not wrong
  for (const auto& [width, height] : {std::pair(320, 180), {640, 200}, {400, 300}}) {
    scene::Scene small = comparison({"rk4", "exact"});
    small.film.width = width;
    small.film.height = height;
    EXPECT_FALSE(compute_layout(small).angle) << width;  // its numbers would overlap
  }
}

}  // namespace
}  // namespace twrench::picture
