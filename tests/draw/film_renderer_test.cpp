#include "draw/film_renderer.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "draw/exposure.h"
#include "gl/test_context.h"
#include "image/compare.h"
#include "picture/compose/layout.h"
#include "picture/views/body_view.h"
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

TEST_F(FilmRendererTest, ShowsNoTextOfThePreviousShotInAFade) {
  scene::Scene film = film_of_shots();
  for (scene::Shot& shot : film.shots) {
    shot.scene.film.width = 640;
    shot.scene.film.height = 360;
  }
  film.film.width = 640;
  film.film.height = 360;
  film.shots[1].scene.overlay.show = {scene::Feature::hud, scene::Feature::axes};
  film.film.text_fade = 0.5;
  film.shots[1].scene.title = "One text";
  scene::Scene other = film;
  other.shots[1].scene.title = "Two text";
  const auto shown = [&](const scene::Scene& of, int frame) { return drawn(of, frame).image; };
  EXPECT_NE(shown(film, 9).pixels, shown(other, 9).pixels);
  EXPECT_NE(shown(film, 11).pixels, shown(other, 11).pixels);
  EXPECT_EQ(shown(film, 12).pixels, shown(other, 12).pixels);
  EXPECT_EQ(shown(film, 13).pixels, shown(other, 13).pixels);
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

/// A film whose camera moves to `frame` in its second shot and back to space in its third.
scene::Scene film_of_frames(const std::string& frame, double size, const std::string& motion) {
  const std::string radius = fmt::format("{}", size);
  return scene::parse_scene(
      "[[part]]\nshape = 'cylinder'\nradius = " + radius +
          "\nlength = " + fmt::format("{}", 8 * size) + "\naxis = [0, 1, 0]\nposition = [" +
          radius + ", 0, 0]\ndensity = 1\n[[part]]\nshape = 'sphere'\nradius = " + radius +
          "\nposition = [" + fmt::format("{}", 3 * size) + ", 0, 0]\ndensity = 3\n" + R"(
[film]
size = [64, 36]
fps = 20
speed = 2
[look]
theme = "space"
[overlay]
show = []
[[shot]]
length = 2
[[shot]]
length = 3
move = 1.5
[shot.camera]
azimuth = 0.4
frame = ")" +
          frame + R"("
[[shot]]
length = 2
move = 2
[motion]
method = "exact"
)" + motion,
      "frames.toml");
}

/// How far one attitude of a camera is turned from another, in rad.
double angle_between(const Camera& one, const Camera& other) {
  return Eigen::AngleAxisd(one.camera_from_space() * other.camera_from_space().transpose()).angle();
}

/// Whether two cameras differ only by round-off, which depends on the compiler.
bool are_alike(const Camera& one, const Camera& other) {
  const Eigen::Vector4d place = one.view.col(3);
  return angle_between(one, other) < 1e-12 &&
         (other.view.col(3) - place).norm() <= 1e-12 * place.norm();
}

TEST_F(FilmRendererTest, MovesTheCameraToAnotherFrameOfReferenceInOnePicture) {
  for (const char* const frame : {"rotating", "body"}) {
    for (const double size : {1e-6, 1.0, 1e5}) {
      for (const char* const motion :
           {"omega = [1, 0.05, 0]", "omega = [0.01, 0.02, 1.3]", "omega = [0.5, 0.4, 0.6]"}) {
        SCOPED_TRACE(fmt::format("{} {} {}", frame, size, motion));
        const scene::Scene scene = film_of_frames(frame, size, motion);
        FilmRenderer renderer(*context, scene);
        const timeline::FilmTimeline timeline(scene, every_frame(scene));
        std::vector<Camera> cameras;
        for (std::size_t i = 0; i < timeline.size(); ++i) {
          const timeline::FilmFrame shown = timeline.frame(i);
          EXPECT_EQ(shown.faded, 1) << "no dissolve";
          cameras.push_back(renderer.camera(timeline, shown));
        }
        EXPECT_TRUE(are_alike(cameras[40], cameras[39])) << "it starts where the first shot ended";
        double last = 0;
        for (std::size_t i = 1; i < cameras.size(); ++i) {
          const double turned = angle_between(cameras[i], cameras[i - 1]);
          EXPECT_LT(std::abs(turned - last), 0.12) << "it jumps at " << i;
          last = turned;
        }
        EXPECT_LT(angle_between(cameras.back(), cameras[0]), 0.02) << "back in space";
        const picture::Camera still = renderer.camera(timeline, timeline.frame(80));
        EXPECT_EQ(still.view, cameras[80].view);
      }
    }
  }
}

TEST_F(FilmRendererTest, FadesOnlyTheSurroundingsWhileTheFrameOfReferenceChanges) {
  scene::Scene film = film_of_frames("rotating", 1, "omega = [1, 0.05, 0]");
  film.shots[1].speed = {{{0, 2}, {0.1, 0.5}}};  // the first shot would be elsewhere at its speed
  const image::Image cut = drawn(film, 50).image;
  film.shots[1].fade = 1;
  EXPECT_LT(image::compare(drawn(film, 50).image, cut, 0)->max, 3) << "the body in one pose";
  film.shots[1].continues = false;
  EXPECT_GT(image::compare(drawn(film, 50).image, cut, 0)->max, 30);
}

TEST_F(FilmRendererTest, TurnsStarsAsTheCameraOfEarlierFramesSawThem) {
  for (const char* const frame : {"rotating", "body"}) {
    scene::Scene film = film_of_frames(frame, 1, "omega = [0.3, 0.02, 0]");
    for (scene::Shot& shot : film.shots) {
      shot.scene.overlay.star_trail = 1.6;  // 32 steps of 1 / 20 s
      shot.scene.camera.orbit = 0.1;
    }
    FilmRenderer renderer(*context, film);
    const timeline::FilmTimeline timeline(film, every_frame(film));
    const auto camera = [&](std::size_t i) { return renderer.camera(timeline, timeline.frame(i)); };
    for (const std::size_t now : {60U, 80U, 99U}) {  // in the move, and after it
      const scene::Scene& scene = film.shots[1].scene;
      const picture::BodyView view(scene, timeline.solutions(1), 0,
                                   picture::compute_layout(scene).panes[0]);
      const auto turning = view.turning(timeline.frame(now).state, camera(now));
      const timeline::FrameState state = timeline.frame(now).state;
      ASSERT_GE(turning.rotations.size(), 33U);
      for (std::size_t i = 0; i < turning.rotations.size(); ++i) {
        const double before = 20 * (state.video_time - state.star_times[i]);
        const std::size_t then = now - static_cast<std::size_t>(std::lround(before));
        const Eigen::Matrix3d expected =
            camera(now).camera_from_space().transpose() * camera(then).camera_from_space();
        EXPECT_LT((turning.rotations[i] - expected).norm(), 1e-9) << now << " " << then;
      }
    }
  }
}

TEST_F(FilmRendererTest, ShowsTheSameStarsBeforeAndAfterTheCameraBeginsToTurn) {
  scene::Scene film = film_of_frames("rotating", 1e-3, "omega = [1, 0.05, 0]");
  for (scene::Shot& shot : film.shots) {
    shot.scene.film.width = 640;
    shot.scene.film.height = 360;
  }
  film.film.width = 640;
  film.film.height = 360;
  film.shots[1].speed = film.shots[0].speed = {{{0, 0}}};  // the body stands still
  film.shots[1].start = 0;
  const image::Image still = drawn(film, 39).image, turning = drawn(film, 40).image;
  EXPECT_GT(*std::ranges::max_element(still.pixels), 100) << "there are stars";
  EXPECT_LT(image::compare(still, turning, 2)->share, 1e-4) << "except on the edges of the body";
}

TEST_F(FilmRendererTest, ReportsWhereAFrameDiffersFromItsBackground) {
  const scene::Scene scene = film_of_shots();
  const auto frames = drawn(scene, every_frame(scene));
  const std::vector<image::Area> everything{{0, 0, 192, 108}};
  EXPECT_NE(frames[0].damage, everything);
  EXPECT_EQ(frames[5].damage.front(), everything.front());
  EXPECT_EQ(frames[0].background, frames[3].background);
  EXPECT_NE(frames[0].background, frames[11].background);
  EXPECT_EQ(frames[10].background, frames[11].background);
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
