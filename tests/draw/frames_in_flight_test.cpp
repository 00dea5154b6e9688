// Frames begun before others are completed are byte-identical to frames that are drawn one by one
// and read at once. Pixels read in bands equal pixels read as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <future>
#include <optional>

#include "draw/renderer.h"
#include "gl/test_context.h"
#include "picture/compose/layer.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using picture::t_wrench;
using picture::unpremultiply;

struct Film {
  const char* name;
  scene::View view = scene::View::wrench;
  int blur = 1;
  int samples = 1;
  bool transparent = false;
  double orbit = 0;
};

/// Returns the frame with its damaged areas restored. This is the static background if the rest is
/// unchanged.
image::Image without_changes(const image::Frame& frame, const image::Image& background) {
  image::Image image = frame.image;
  const auto channels = static_cast<std::size_t>(image.channels);
  for (const image::Area& area : frame.damage) {
    for (int y = area.y; y < area.y + area.height; ++y) {
      const auto first =
          static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * image.row_bytes() +
                                      static_cast<std::size_t>(area.x) * channels);
      std::copy_n(background.pixels.begin() + first,
                  static_cast<std::size_t>(area.width) * channels, image.pixels.begin() + first);
    }
  }
  return image;
}

void PrintTo(const Film& film, std::ostream* out) { *out << film.name; }

class FramesInFlight : public testing::TestWithParam<Film> {
 protected:
  static scene::Scene scene() {
    scene::Scene scene = t_wrench(320, 180);
    using enum scene::Feature;
    scene.overlay.show = {axes,  momentum, omega,   trail, plane,     labels,
                          floor, sphere,   poinsot, hud,   components};
    scene.overlay.view = GetParam().view;
    scene.look.motion_blur = GetParam().blur;
    scene.look.samples = GetParam().samples;
    scene.look.transparent = GetParam().transparent;
    scene.camera.orbit = GetParam().orbit;
    return scene;
  }
};

TEST_P(FramesInFlight, AreThoseDrawnOneByOne) {
  const scene::Scene film = scene();
  const timeline::Timeline timeline(film, {0, 250, 590, 600});
  const auto context = gl::make_test_context();
  std::vector<image::Frame> expected;
  {
    Renderer renderer(*context, film, timeline.solutions(), gl::ReadMode::at_once);
    for (std::size_t i = 0; i < 4; ++i) expected.push_back(renderer.draw(timeline.frame_state(i)));
    ASSERT_NE(expected[0].image.pixels, expected[1].image.pixels);
  }
  for (const gl::ReadMode mode : {gl::ReadMode::at_once, gl::ReadMode::buffered}) {
    Renderer renderer(*context, film, timeline.solutions(), mode);
    image::Image background = *expected[0].background;
    if (film.look.transparent)
      unpremultiply(background, {0, 0, background.width, background.height});
    std::vector<image::PendingFrame> begun;
    for (std::size_t i = 0; i < 3; ++i) begun.push_back(renderer.begin(timeline.frame_state(i)));
    const auto expect = [&](std::size_t i) {
      const image::Frame frame = begun[i].get();
      EXPECT_EQ(frame.image.pixels, expected[i].image.pixels) << i;
      EXPECT_EQ(without_changes(frame, background).pixels, background.pixels) << i;
    };
    expect(1);
    begun.push_back(renderer.begin(timeline.frame_state(3)));
    for (const std::size_t i : {3U, 0U, 2U}) expect(i);
  }
}

TEST_P(FramesInFlight, AreCompositedWhileOthersAreDrawn) {
  const scene::Scene film = scene();
  const timeline::Timeline timeline(film, {0, 250, 590, 600});
  const auto context = gl::make_test_context();
  std::vector<image::Image> expected;
  {
    Renderer renderer(*context, film, timeline.solutions(), gl::ReadMode::at_once);
    for (std::size_t i = 0; i < 4; ++i) {
      expected.push_back(renderer.draw(timeline.frame_state(i)).image);
    }
  }
  for (const gl::ReadMode mode : {gl::ReadMode::at_once, gl::ReadMode::buffered}) {
    Renderer renderer(*context, film, timeline.solutions(), mode);
    std::future<image::Frame> composited;
    for (std::size_t i = 0; i < 5; ++i) {
      std::optional<image::PendingFrame> begun;
      if (i < 4) {
        begun.emplace(renderer.begin(timeline.frame_state(i)));
        begun->fetch();
      }
      if (composited.valid()) {
        EXPECT_EQ(composited.get().image.pixels, expected[i - 1].pixels) << i;
      }
      if (begun) {
        composited = std::async(std::launch::async,
                                [frame = std::move(*begun)]() mutable { return frame.finish(); });
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FramesInFlight,
                         testing::Values(Film{"plain"},
                                         Film{"orbit", scene::View::quad, 1, 1, false, 0.5},
                                         Film{"blurred", scene::View::wrench, 12},
                                         Film{"multisampled", scene::View::quad, 1, 4},
                                         Film{"transparent", scene::View::wrench, 1, 1, true}),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(FramesAhead, AreAsManyAsHidePixelsOnTheirWay) {
  const scene::Scene film = t_wrench();
  const timeline::Timeline timeline(film, {0});
  const auto context = gl::make_test_context();
  EXPECT_EQ(Renderer(*context, film, timeline.solutions()).frames_ahead(), 0)
      << "drawn in software";
  EXPECT_EQ(Renderer(*context, film, timeline.solutions(), gl::ReadMode::buffered).frames_ahead(),
            1);
}

}  // namespace
}  // namespace twrench::draw
