// Tests whether text, arrows and curves are legible in frames as drawn, and composited.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>

#include "draw/renderer.h"
#include "gl/test_context.h"
#include "picture/body/bounding_radius.h"
#include "picture/color_vision.h"
#include "picture/compose/layout.h"
#include "picture/look/theme.h"
#include "picture/overlay/body_overlay.h"
#include "picture/overlay/trail_point.h"
#include "picture/t_wrench.h"
#include "sanitizers.h"

namespace twrench::draw {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using enum scene::Feature;
using picture::BodyOverlay;
using picture::bounding_radius;
using picture::Camera;
using picture::compute_layout;
using picture::distance;
using picture::Layout;
using picture::luminance;
using picture::OverlayColors;
using picture::pixel_of;
using picture::style_of;
using picture::t_wrench;
using picture::trail_point;

constexpr int full_width = 1280, full_height = 720;
const image::Area whole{0, 0, full_width, full_height};

Color color_at(const image::Image& image, int x, int y) {
  const std::uint8_t* p = &image.pixels[static_cast<std::size_t>(y) * image.row_bytes() +
                                        static_cast<std::size_t>(x * image.channels)];
  return {p[0], p[1], p[2]};
}

int difference(const Color& a, const Color& b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

/// Returns a transparent frame composited over a background.
image::Image composited(const image::Image& frame, const Color& ground) {
  if (frame.channels == 3) return frame;
  image::Image image(frame.width, frame.height, 3);
  const std::array behind{ground.red, ground.green, ground.blue};
  for (std::size_t i = 0; i < frame.pixels.size() / 4; ++i) {
    const int alpha = frame.pixels[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[3 * i + c] = static_cast<std::uint8_t>(
          (frame.pixels[4 * i + c] * alpha + behind[c] * (255 - alpha)) / 255);
    }
  }
  return image;
}

/// Returns the highest contrast between a pixel and any other within `reach` px.
double contrast_around(const image::Image& image, int x, int y, int reach) {
  double low = 1, high = 0;  // luminance
  for (int v = std::max(0, y - reach); v <= std::min(image.height - 1, y + reach); ++v) {
    for (int u = std::max(0, x - reach); u <= std::min(image.width - 1, x + reach); ++u) {
      const double shown = luminance(color_at(image, u, v));
      low = std::min(low, shown);
      high = std::max(high, shown);
    }
  }
  const double here = luminance(color_at(image, x, y));
  return std::max((high + 0.05) / (here + 0.05), (here + 0.05) / (low + 0.05));
}

/// Returns the contrasts of the pixels in `area` that have the colour of an ink, up to a sixth of
/// coverage, and differ from the same pixels in `without`.
std::vector<double> contrasts_of(const Color& ink, const image::Image& image,
                                 const image::Area& area, const image::Image& without) {
  constexpr int same = 60, other = 10, reach = 3;
  std::vector<double> contrasts;
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) {
      const Color here = color_at(image, x, y);
      if (difference(here, ink) > same) continue;
      if (difference(here, color_at(without, x, y)) < other) continue;
      contrasts.push_back(contrast_around(image, x, y, reach));
    }
  }
  return contrasts;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.at(values.size() / 2);
}

struct Look {
  const char* name;
  scene::Theme theme;
  bool transparent;
  std::optional<Color> background;
};

void PrintTo(const Look& look, std::ostream* out) { *out << look.name; }

constexpr Color white{255, 255, 255}, black{0, 0, 0}, violet{138, 43, 226};

class Legibility : public testing::TestWithParam<Look> {
 protected:
  Legibility() {
    scene.look.theme = GetParam().theme;
    scene.look.transparent = GetParam().transparent;
    scene.look.background = GetParam().background;
    scene.motion.method = "exact";
    scene.title = "Legible";
  }

  void SetUp() override {
    const bool is_like_others = scene.look.theme != scene::Theme::studio || scene.look.background;
    if (has_sanitizers && is_like_others) GTEST_SKIP() << "draws the same as other tests";
  }

  image::Image drawn(std::set<scene::Feature> features, int frame) {
    scene.overlay.show = std::move(features);
    const timeline::Timeline timeline(scene, {frame});
    Renderer renderer(*context, scene, timeline.solutions());
    const timeline::FrameState state = timeline.frame_state(0);
    camera = renderer.camera(state);
    return renderer.draw(state).image;
  }

  /// Returns the backgrounds over which a frame is composited; only one if the frame has its own.
  std::vector<Color> grounds() const {
    return GetParam().transparent ? std::vector{white, black, violet} : std::vector{black};
  }

  /// Returns the frame over each of the backgrounds.
  std::vector<image::Image> seen(const image::Image& frame) const {
    std::vector<image::Image> images;
    for (const Color& ground : grounds()) images.push_back(composited(frame, ground));
    return images;
  }

  std::unique_ptr<gl::Context> context = gl::make_test_context();
  scene::Scene scene = t_wrench(full_width, full_height);
  const OverlayColors& colors = style_of(GetParam().theme).overlay;
  Camera camera;
};

INSTANTIATE_TEST_SUITE_P(Each, Legibility,
                         testing::Values(Look{"studio", scene::Theme::studio, false, {}},
                                         Look{"paper", scene::Theme::paper, false, {}},
                                         Look{"space", scene::Theme::space, false, {}},
                                         Look{"studioTransparent", scene::Theme::studio, true, {}},
                                         Look{"paperTransparent", scene::Theme::paper, true, {}},
                                         Look{"spaceTransparent", scene::Theme::space, true, {}},
                                         Look{"studioOnViolet", scene::Theme::studio, false,
                                              violet},
                                         Look{"studioOnWhite", scene::Theme::studio, false, white},
                                         Look{"paperOnViolet", scene::Theme::paper, false, violet}),
                         [](const auto& param) { return std::string(param.param.name); });

TEST_P(Legibility, OfLabelsIsThatOfText) {
  for (const int frame : {40, 71}) {
    const image::Image bare = drawn({axes, momentum, omega}, frame);
    const image::Image labelled = drawn({axes, momentum, omega, labels}, frame);
    for (const Color& ground : grounds()) {
      const image::Image without = composited(bare, ground), with = composited(labelled, ground);
      for (const Color& ink :
           {colors.axis[0], colors.axis[1], colors.axis[2], colors.momentum, colors.omega}) {
        const auto contrasts = contrasts_of(ink, with, whole, without);
        ASSERT_GE(contrasts.size(), 3U) << to_string(ink) << " in " << frame;
        EXPECT_GE(median(contrasts), 4.5)
            << to_string(ink) << " on " << to_string(ground) << " in " << frame;
      }
    }
  }
}

TEST_P(Legibility, OfTextAndCurvesIsThatOfText) {
  const image::Image none = drawn({momentum}, 590);
  const image::Image all = drawn({momentum, hud, components}, 590);
  const Layout layout = compute_layout(scene);
  const image::Area &title = layout.title.value(), &readouts = layout.readouts.value(),
                    &panel = layout.components.value();
  for (const Color& ground : grounds()) {
    const image::Image without = composited(none, ground), with = composited(all, ground);
    const auto expect_legible = [&](const Color& ink, const image::Area& area) {
      const auto contrasts = contrasts_of(ink, with, area, without);
      ASSERT_GT(contrasts.size(), 10U) << to_string(ink);
      EXPECT_GE(median(contrasts), 4.5) << to_string(ink) << " on " << to_string(ground);
    };
    expect_legible(colors.text, title);
    expect_legible(colors.text, readouts);
    expect_legible(colors.curve[0], panel);
  }
}

// Checks, along each arrow near its end, the contrast of its middle with its surroundings, and its
// mean colour.
TEST_P(Legibility, OfArrowsIsThatOfGraphics) {
  std::map<std::string, Vector3d> sums;
  std::map<std::string, int> counts;
  for (const int frame : {40, 71, 105, 300}) {
    const std::vector<image::Image> images = seen(drawn({axes, momentum, omega}, frame));
    const timeline::Timeline timeline(scene, {frame});
    const double radius = bounding_radius(scene::visible_parts(scene.body));
    const BodyOverlay overlay(scene, timeline.solutions()[0].body, radius);
    const motion::Sample sample = timeline.frame_state(0).solutions[0].sample;
    std::map<std::string, std::pair<Vector3d, Color>> arrows{
        {"L", {overlay.momentum_tip(), colors.momentum}},
        {"omega", {overlay.omega_tip(sample), colors.omega}}};
    for (int i = 0; i < 3; ++i) {
      arrows[std::string(1, "xyz"[i])] = {overlay.bounding_radius() * sample.X.col(i),
                                          colors.axis[static_cast<std::size_t>(i)]};
    }
    for (const auto& [name, arrow] : arrows) {
      for (double share = 0.6; share < 0.98; share += 0.01) {
        const Vector2d place = pixel_of(camera, whole, share * arrow.first);
        const auto x = static_cast<int>(place.x()), y = static_cast<int>(place.y());
        const Color here = color_at(images[0], x, y);
        // Neither the body nor another arrow hides it: the hue is the same, and the lightness
        // nearly.
        const Eigen::Vector3d ink(arrow.second.red, arrow.second.green, arrow.second.blue),
            shown(here.red, here.green, here.blue);
        if (ink.normalized().dot(shown.normalized()) < 0.993 || shown.norm() < 0.65 * ink.norm())
          continue;
        for (std::size_t i = 0; i < images.size(); ++i) {
          EXPECT_GE(contrast_around(images[i], x, y, 7), 3)
              << name << " on background " << i << " in " << frame;
        }
        sums.try_emplace(name, Vector3d::Zero()).first->second += shown;
        ++counts[name];
      }
    }
  }
  const auto mean = [&](const std::string& name) {
    EXPECT_GT(counts[name], 10) << name;
    const Eigen::Vector3i color = (sums[name] / counts[name]).cast<int>();
    return Color{color.x(), color.y(), color.z()};
  };
  EXPECT_GE(distance(mean("L"), mean("omega")), 20);
  EXPECT_GE(distance(mean("y"), mean("z")), 20);
}

TEST_P(Legibility, OfTheTrailIsThatOfGraphics) {
  const std::vector<image::Image> images = seen(drawn({momentum, trail}, 105));
  const timeline::Timeline timeline(scene, {105});
  const timeline::FrameState state = timeline.frame_state(0);
  const Vector3d point = trail_point(scene);
  const auto& samples = state.solutions[0].trail;
  for (std::size_t i = 4 * samples.size() / 5; i < samples.size(); ++i) {
    const Vector2d place = pixel_of(camera, whole, samples[i].X * point);
    const auto x = static_cast<int>(place.x()), y = static_cast<int>(place.y());
    for (std::size_t k = 0; k < images.size(); ++k) {
      EXPECT_GE(contrast_around(images[k], x, y, 7), 3)
          << samples.size() - i << " before the end on background " << k;
    }
  }
}

/// Returns the contrasts of the pixels that have nearly the colour of an ink.
std::vector<double> contrasts_near(const Color& ink, const image::Image& image) {
  constexpr int nearly = 60, reach = 7;
  std::vector<double> contrasts;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (difference(color_at(image, x, y), ink) <= nearly)
        contrasts.push_back(contrast_around(image, x, y, reach));
    }
  }
  return contrasts;
}

// Checks the axes, the levels about them, and the level of the motion with its trail.
TEST_P(Legibility, OfCurvesOnTheMomentumSphereIsThatOfGraphics) {
  scene.overlay.view = scene::View::momentum;
  for (const image::Image& image : seen(drawn({trail}, 118))) {
    for (const auto& ink : {colors.axis[0], colors.axis[1], colors.axis[2], colors.momentum}) {
      const std::vector<double> contrasts = contrasts_near(ink, image);
      ASSERT_GE(contrasts.size(), 40U) << to_string(ink);
      EXPECT_GE(median(contrasts), 3) << to_string(ink);
    }
  }
}

// Checks the polhode, the herpolhode's trail and the arrows.
TEST_P(Legibility, OfCurvesOnPoinsotsEllipsoidIsThatOfGraphics) {
  scene.overlay.view = scene::View::poinsot;
  for (const image::Image& image : seen(drawn({trail}, 118))) {
    for (const auto& ink : {colors.momentum, colors.omega}) {
      const std::vector<double> contrasts = contrasts_near(ink, image);
      ASSERT_GE(contrasts.size(), 40U) << to_string(ink);
      EXPECT_GE(median(contrasts), 3) << to_string(ink);
    }
  }
}

}  // namespace
}  // namespace twrench::draw
