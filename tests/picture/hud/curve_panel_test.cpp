#include "picture/hud/curve_panel.h"

#include <gtest/gtest.h>

#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

scene::Scene curve_film(int width = 1920, int height = 1080) {
  scene::Scene scene = film_of(width, height);
  scene.motion.method = "exact";
  return scene;
}

std::vector<Layer> drawn_curve(const OverlayScene& film, const timeline::FrameState& state) {
  CurvePanel panel(film.scene, film.timeline.solutions(), film.layout, film.typeface, film.colors);
  return panel.draw(state);
}

std::vector<Layer> drawn_curve(const scene::Scene& scene) {
  const OverlayScene film(scene);
  return drawn_curve(film, film.timeline.frame_state(0));
}

TEST(CurvePanel, ShowsX11AndNoOtherComponent) {
  const OverlayScene film(curve_film());
  timeline::FrameState state = film.timeline.frame_state(0);
  const auto before = drawn_curve(film, state);
  Eigen::Matrix3d& X = state.solutions[0].sample.X;
  X = Eigen::Vector3d(1, -1, -1).asDiagonal();
  EXPECT_TRUE(same(drawn_curve(film, state), before));
  X(0, 0) = -0.5;
  EXPECT_FALSE(same(drawn_curve(film, state), before));
}

/// A picture of the panel at t = 0 with another attitude in its place.
std::vector<Layer> drawn_at(const OverlayScene& film, const Eigen::Matrix3d& attitude) {
  timeline::FrameState state = film.timeline.frame_state(0);
  state.solutions[0].sample.X = attitude;
  return drawn_curve(film, state);
}

Eigen::Matrix3d half_turn(const Eigen::Vector3d& axis) {
  return 2 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
}

/// The film of a body with the principal moments (1, 2, 3) times the scale about these axes, which
/// spins about one of them.
OverlayScene spinning(const Eigen::Matrix3d& axes, int spin, double scale) {
  scene::Scene scene = curve_film();
  const Eigen::Vector3d moments(scale, 2 * scale, 3 * scale);
  scene.body = {{}, axes * moments.asDiagonal() * axes.transpose()};
  scene.motion.omega = axes.col(spin) + 0.02 * axes.col((spin + 1) % 3);
  return OverlayScene(scene);
}

TEST(CurvePanel, FollowsTheAxisThatTurnsOver) {
  Eigen::Matrix3d as_given = Eigen::Matrix3d::Identity(), turned, between;
  turned << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // The intermediate axis is z.
  between = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  for (const Eigen::Matrix3d& axes : {as_given, turned, between}) {
    for (const double scale : {1e-12, 1.0, 1e12}) {
      for (const int spin : {0, 1, 2}) {
        const OverlayScene film = spinning(axes, spin, scale);
        const auto start = drawn_at(film, Eigen::Matrix3d::Identity());
        for (const int axis : {0, 1, 2}) {
          const auto after = drawn_at(film, half_turn(axes.col(axis)));
          EXPECT_EQ(same(start, after), axis == spin) << axes << "\n" << spin << ", " << scale;
        }
      }
    }
  }
}

TEST(CurvePanel, StartsAtOneWithAnyAttitude) {
  scene::Scene scene = curve_film();
  scene.motion.attitude = Eigen::Quaterniond(0.8, 0, 0.6, 0);
  const OverlayScene tilted(scene);
  const Eigen::Matrix3d start = tilted.timeline.frame_state(0).solutions[0].sample.X;
  const auto drawn = drawn_at(tilted, start);
  const Eigen::Matrix3d about_x = half_turn(Eigen::Vector3d::UnitX());
  EXPECT_TRUE(same(drawn_at(tilted, start * about_x), drawn));
  EXPECT_FALSE(same(drawn_at(tilted, Eigen::Matrix3d::Identity()), drawn));
}

TEST(CurvePanel, TicksTheFlipsOfTheMethodItself) {
  const OverlayScene film(curve_film());
  std::vector<timeline::Solution> moved = film.timeline.solutions();
  moved[0].flip_times[2] += 5;
  CurvePanel one(film.scene, film.timeline.solutions(), film.layout, film.typeface, film.colors);
  CurvePanel other(film.scene, moved, film.layout, film.typeface, film.colors);
  const timeline::FrameState state = film.timeline.frame_state(0);
  EXPECT_FALSE(same(one.draw(state), other.draw(state)));
}

TEST(CurvePanel, PointsItsArrowsAsTheCameraSeesThem) {
  scene::Scene scene = curve_film();
  const auto front = drawn_curve(scene);
  scene.camera.azimuth = 0.3;
  EXPECT_TRUE(same(drawn_curve(scene), front));
  scene.camera.azimuth = 3;
  EXPECT_FALSE(same(drawn_curve(scene), front)) << "from behind, space x points to the left";
  scene.camera.azimuth = 0;
  scene.camera.orbit = 0.1;
  EXPECT_FALSE(same(drawn_curve(scene), front)) << "numbers where it points to either side";
}

TEST(CurvePanel, FitsWhateverAreaItIsGiven) {
  const image::Area picture{0, 0, 200, 100};
  OverlayScene small(curve_film(picture.width, picture.height));
  small.scene.motion.omega = {1, 0.05, 0};
  for (const image::Area& area : {image::Area{10, 5, 180, 90},
                                  {90, 45, 12, 8},
                                  {0, 0, 1, 1},
                                  {0, 0, 200, 100},
                                  {0, 40, 200, 9},
                                  {0, 0, 9, 100},
                                  {150, 10, 120, 80},
                                  {300, 20, 160, 80}}) {
    small.layout.curve = area;
    for (const Layer& layer : drawn_curve(small, small.timeline.frame_state(0))) {
      EXPECT_EQ(image::common(layer.area(), picture), layer.area()) << area.x << " " << area.y;
    }
  }
}

TEST(CurvePanel, HoldsAnyNumberOfFlips) {
  scene::Scene scene = curve_film();
  for (const double duration : {1.0, 20.0, 2000.0}) {
    scene.motion.duration = duration;
    EXPECT_EQ(drawn_curve(scene).size(), 1U) << duration;
  }
}

}  // namespace
}  // namespace twrench::picture
