#include "draw/film_renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <numeric>

#include "draw/cross_fade.h"
#include "gl/test_context.h"
#include "scene/scene.h"

namespace twrench::draw {
namespace {

using picture::Camera;

using testing::HasSubstr;

const std::string shared_tables = R"(
[[part]]
shape = "cylinder"
radius = 1.0
length = 8.0
axis = [0, 1, 0]
density = 1
[motion]
omega = [1, 0.05, 0]
method = "exact"
[film]
size = [192, 108]
fps = 4
speed = 1
[overlay]
show = ["floor"]
)";

scene::Scene film_of_shots(const std::string& look = "") {
  return scene::parse_scene(look + shared_tables + R"(
[[shot]]
length = 1
[[shot]]
length = 2
fade = 1
move = 1
[shot.overlay]
show = ["floor", "momentum", "axes"]
[shot.camera]
azimuth = 1
distance = 1.3
[[shot]]
length = 1
fade = 0.5
[shot.look]
theme = "paper"
[shot.overlay]
view = "momentum"
)",
                            "story.toml");
}

class FilmRendererTest : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();

  /// Draws the film's frames in this order. All are begun before the first is completed.
  std::vector<image::Frame> drawn(const scene::Scene& scene, const std::vector<int>& frames) {
    FilmRenderer renderer(*context, scene);
    const timeline::FilmTimeline timeline(scene, frames);
    std::vector<image::PendingFrame> pending;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const timeline::FilmFrame frame = timeline.frame(i);
      pending.push_back(renderer.begin(timeline, frame, renderer.camera(timeline, frame)));
    }
    std::vector<image::Frame> pictures;
    for (image::PendingFrame& frame : pending) pictures.push_back(frame.get());
    return pictures;
  }

  image::Frame drawn(const scene::Scene& scene, int frame) {
    return std::move(drawn(scene, std::vector{frame}).front());
  }
};

std::vector<int> every_frame(const scene::Scene& scene) {
  std::vector<int> frames(static_cast<std::size_t>(scene.frame_count()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

TEST_F(FilmRendererTest, DrawsEachFrameAsIfItWereTheOnlyOne) {
  for (const char* look : {"", "look = {background = 'transparent'}\n"}) {
    const scene::Scene scene = film_of_shots(look);
    const auto all = drawn(scene, every_frame(scene));
    ASSERT_EQ(all.size(), 16u);
    for (const int number : {0, 4, 5, 9, 12, 13, 15}) {
      EXPECT_EQ(drawn(scene, number).image.pixels,
                all[static_cast<std::size_t>(number)].image.pixels)
          << number;
    }
  }
}

TEST_F(FilmRendererTest, DrawsAFilmOfOneMotionAsItsRendererDoes) {
  scene::Scene scene = scene::parse_scene(shared_tables, "film.toml");
  scene.motion.duration = 2;
  const timeline::Timeline timeline(scene, {5});
  Renderer alone(*context, scene, timeline.solutions());
  EXPECT_EQ(drawn(scene, 5).image.pixels, alone.draw(timeline.frame_state(0)).image.pixels);
}

TEST_F(FilmRendererTest, FadesFromThePreviousShot) {
  scene::Scene scene = film_of_shots();
  scene.shots.erase(scene.shots.begin() + 1);  // from the body to the momentum sphere
  const image::Image first = drawn(scene, 4).image, middle = drawn(scene, 5).image;
  scene::Scene before = scene, after = scene;
  before.shots[0].scene.length = 2;
  after.shots[1].fade = 0;
  EXPECT_EQ(first.pixels, drawn(before, 4).image.pixels) << "still the previous shot";
  EXPECT_EQ(middle.pixels, cross_fade(drawn(before, 5).image, drawn(after, 5).image, 0.5).pixels);
  EXPECT_NE(middle.pixels, drawn(after, 5).image.pixels);
}

TEST_F(FilmRendererTest, MovesTheCameraOfBothShots) {
  const scene::Scene scene = film_of_shots();
  FilmRenderer renderer(*context, scene);
  const timeline::FilmTimeline timeline(scene, every_frame(scene));
  const auto camera = [&](std::size_t frame) {
    return renderer.camera(timeline, timeline.frame(frame));
  };
  const Camera before = camera(3), start = camera(4), middle = camera(6), end = camera(10);
  EXPECT_EQ(start.view, before.view);
  EXPECT_EQ(start.projection, before.projection);
  EXPECT_GT(middle.distance, start.distance);
  EXPECT_LT(middle.distance, end.distance);
  EXPECT_EQ(camera(11).view, end.view);
  // The shots then differ in nothing else and are seen from one place, so the fade is invisible.
  scene::Scene plain = scene;
  plain.shots[1].scene.overlay = plain.shots[0].scene.overlay;
  scene::Scene cut = plain;
  cut.shots[1].fade = 0;
  EXPECT_EQ(drawn(plain, 6).image.pixels, drawn(cut, 6).image.pixels);
}

TEST_F(FilmRendererTest, TellsWhereAFrameDiffersFromItsBackground) {
  const scene::Scene scene = film_of_shots();
  const auto frames = drawn(scene, every_frame(scene));
  const std::vector<image::Area> everything{{0, 0, 192, 108}};
  EXPECT_NE(frames[0].damage, everything);
  EXPECT_EQ(frames[5].damage.front(), everything.front());
  EXPECT_EQ(frames[0].background, frames[3].background);
  EXPECT_NE(frames[0].background, frames[11].background);
  EXPECT_EQ(frames[10].background, frames[11].background);
}

TEST_F(FilmRendererTest, LendsTheMemoryOfAShotsFrames) {
  const scene::Scene scene = film_of_shots();
  FilmRenderer renderer(*context, scene);
  const timeline::FilmTimeline timeline(scene, every_frame(scene));
  const auto expected = drawn(scene, every_frame(scene));
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    image::Frame frame = renderer.draw(timeline, timeline.frame(i));
    EXPECT_EQ(frame.image.pixels, expected[i].image.pixels) << i;
    renderer.reuse(std::move(frame));
  }
}

TEST_F(FilmRendererTest, NamesTheShotThatCannotBeDrawn) {
  const auto message = [&](const std::string& shot) -> std::string {
    const scene::Scene scene = scene::parse_scene(
        shared_tables + "[[shot]]\nlength = 1\n[[shot]]\nlength = 1\n" + shot, "s.toml");
    try {
      FilmRenderer(*context, scene);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return {};
  };
  std::string longer = "caption = \"";
  for (int i = 0; i < 40; ++i) longer += "word ";
  EXPECT_EQ(message("caption = 'short'"), "") << "in a picture too small for it";
  scene::Scene scene = scene::parse_scene(
      shared_tables + "[[shot]]\nlength = 1\n[[shot]]\nlength = 1\n" + longer + "\"", "s.toml");
  for (scene::Shot& shot : scene.shots) shot.scene.film.width = shot.scene.film.height = 400;
  try {
    FilmRenderer(*context, scene);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("s.toml:19: shot[1]: caption: needs more than the 3 lines"));
  }
  EXPECT_THAT(message("[shot.overlay]\nview = 'quad'\ncompare = ['rk4', 'exact']"),
              HasSubstr("s.toml:19: shot[1]: compare"));
}

}  // namespace
}  // namespace twrench::draw
