// Complete frames with overlays, compared with images that were inspected and found correct; see
// golden_test.cpp.
#include <gtest/gtest.h>

#include "base/enumeration.h"
#include "draw/renderer.h"
#include "gl/test_context.h"
#include "picture/golden.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using picture::expect_golden;
using picture::t_wrench;

struct FilmGolden {
  const char* name;
  std::set<scene::Feature> show;
  scene::View view = scene::View::wrench;
  int frame = 590;
  Eigen::Vector3d omega{1, 0.05, 0};
  double elevation = 0.245;
};

void PrintTo(const FilmGolden& golden, std::ostream* out) { *out << golden.name; }

std::vector<FilmGolden> film_goldens() {
  using enum scene::Feature;
  return {
      {"film-axes", {axes}},
      {"film-arrows", {momentum, omega}},
      {"film-trail", {trail}},
      {"film-plane", {momentum, omega, trail, plane}, scene::View::wrench, 600},
      {"film-from-above",
       {axes, momentum, plane},
       scene::View::wrench,
       590,
       {1, 0.05, 0},
       1.5707963},
      {"film-inertia", {inertia}, scene::View::wrench, 600},
      {"film-insets", {momentum, omega, trail, sphere, poinsot}, scene::View::wrench, 600},
      {"film-momentum", {trail}, scene::View::momentum, 280},
      {"film-phase", {trail, phase}, scene::View::momentum, 280, {0.2, 0.3, -1}},
      {"film-momentum-stable", {trail}, scene::View::momentum, 280, {0.2, 0.1, -1}},
      {"film-poinsot", {trail}, scene::View::poinsot, 240},
      {"film-quad", {momentum, omega, trail}, scene::View::quad, 590},
  };
}

class GoldenFilm : public testing::TestWithParam<FilmGolden> {};

TEST_P(GoldenFilm, IsDrawn) {
  const FilmGolden& golden = GetParam();
  scene::Scene scene = t_wrench(480, 270);
  scene.overlay.show = golden.show;
  scene.overlay.view = golden.view;
  scene.motion.omega = golden.omega;
  scene.motion.method = "exact";  // its frames do not depend on steps
  scene.camera.elevation = golden.elevation;
  const timeline::Timeline timeline(scene, {golden.frame});
  const auto context = gl::make_test_context();
  Renderer renderer(*context, scene, timeline.solutions());
  expect_golden(golden.name, renderer.draw(timeline.frame_state(0)).image);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenFilm, testing::ValuesIn(film_goldens()), [](const auto& param) {
  std::string name(param.param.name);
  std::erase(name, '-');
  return name;
});

// The floor is tested in golden_test.cpp, its shadow alone in floor_test.cpp, texts and panels in
// tests/picture/overlay_golden_test.cpp, and the overlays of forces elsewhere.
TEST(GoldenFilms, ShowEachOverlayOfTheViews) {
  using enum scene::Feature;
  std::set<scene::Feature> shown{floor, shadow, labels,  hud, components, curve,  method,
                                 drift, forces, torques, tip, tilt,       moments};
  for (const FilmGolden& golden : film_goldens())
    shown.insert(golden.show.begin(), golden.show.end());
  for (const scene::Feature feature : enumerators<scene::Feature>) {
    EXPECT_TRUE(shown.contains(feature)) << enumerator_name(feature) << " has no golden image";
  }
}

}  // namespace
}  // namespace twrench::draw
