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
