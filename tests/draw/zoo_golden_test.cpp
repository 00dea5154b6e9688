// A small frame of each body of the zoo, compared with an image that was inspected and found
// correct; see golden_test.cpp.
#include <gtest/gtest.h>

#include "draw/film_renderer.h"
#include "gl/test_context.h"
#include "picture/golden.h"
#include "sanitizers.h"
#include "scene/scene.h"

namespace twrench::draw {
namespace {

using picture::expect_golden;

struct ZooGolden {
  const char* name;
  int frame;
  bool is_like_others = false;  ///< Under sanitizers the others suffice.
};

void PrintTo(const ZooGolden& golden, std::ostream* out) { *out << golden.name; }

/// Returns the scene without text, which depends on the fonts and the release of Cairo.
scene::Scene small_and_mute(const std::string& name) {
  scene::Scene film = scene::load_scene(name);
  film.film.width = 320;
  film.film.height = 180;
  using enum scene::Feature;
  film.overlay.show = {floor, momentum, omega, trail};
  for (scene::Shot& shot : film.shots) {
    shot.scene.film = film.film;
    shot.scene.overlay.show = film.overlay.show;
    shot.scene.caption.reset();
  }
  return film;
}

class GoldenZoo : public testing::TestWithParam<ZooGolden> {};

TEST_P(GoldenZoo, IsDrawn) {
  const ZooGolden& golden = GetParam();
  if (has_sanitizers && golden.is_like_others) GTEST_SKIP() << "draws the same as other tests";
  const scene::Scene film = small_and_mute(golden.name);
  const timeline::FilmTimeline timeline(film, {golden.frame});
  const auto context = gl::make_test_context();
  FilmRenderer renderer(*context, film);
  const image::Frame frame = renderer.draw(timeline, timeline.frame(0));
  expect_golden(std::string("zoo-") + golden.name, frame.image);
}

INSTANTIATE_TEST_SUITE_P(
    All, GoldenZoo,
    testing::Values(ZooGolden{"t-handle", 425, true}, ZooGolden{"wing-nut", 150, true},
                    ZooGolden{"tennis-racket", 108, true}, ZooGolden{"phone", 103},
                    ZooGolden{"book", 126}, ZooGolden{"hammer", 112}, ZooGolden{"tao-disk", 150},
                    ZooGolden{"toutatis", 200}, ZooGolden{"explorer-1", 780, true}),
    [](const auto& param) {
      std::string name(param.param.name);
      std::erase(name, '-');
      return name;
    });

}  // namespace
}  // namespace twrench::draw
