// Tests what the lights of a theme promise: the body stands out from the background, and its
// highlights keep their shape.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "base/enumeration.h"
#include "draw/renderer.h"
#include "gl/test_context.h"
#include "picture/t_wrench.h"
#include "sanitizers.h"

namespace twrench::draw {
namespace {

/// Draws the default film at twenty times, three flips.
std::vector<image::Image> film(scene::Theme theme, bool is_transparent) {
  const std::unique_ptr<gl::Context> context = gl::make_test_context();
  scene::Scene scene = picture::t_wrench(1280, 720);
  scene.look.theme = theme;
  scene.look.transparent = is_transparent;
  scene.overlay.show = {};
  if (!is_transparent) scene.overlay.show = {scene::Feature::floor};
  std::vector<int> frames;
  for (int frame = 5; frame < 960; frame += 50) frames.push_back(frame);
  const timeline::Timeline timeline(scene, frames);
  Renderer renderer(*context, scene, timeline.solutions());
  std::vector<image::Image> images;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    images.push_back(renderer.draw(timeline.frame_state(i)).image);
  }
  return images;
}

double linear(double srgb) {
  const double s = srgb / 255;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// The pixel, or the nearest one if it is beside the image.
const std::uint8_t* nearest_pixel(const image::Image& image, int x, int y) {
  const int row = std::clamp(y, 0, image.height - 1), column = std::clamp(x, 0, image.width - 1);
  return &image.pixels[static_cast<std::size_t>(row) * image.row_bytes() +
                       static_cast<std::size_t>(column * image.channels)];
}

/// The relative luminance of WCAG 2.1.
double luminance(const std::uint8_t* p) {
  return 0.2126 * linear(p[0]) + 0.7152 * linear(p[1]) + 0.0722 * linear(p[2]);
}

/// The luminance of some pixels.
struct Mean {
  double sum = 0, count = 0;
  void add(double value) { sum += value, ++count; }
  double value() const { return sum / count; }
};

/// Whether the square of 5 x 5 pixels about this one contains background.
bool is_near_background(const image::Image& cutout, int x, int y) {
  for (int i = 0; i < 25; ++i) {
    if (nearest_pixel(cutout, x + i % 5 - 2, y + i / 5 - 2)[3] == 0) return true;
  }
  return false;
}

/// The fraction of the outline along which the body differs from the background by a contrast of
/// 1.3, both averaged over squares of 5 x 5 pixels. `cutout` is the body alone.
double visible_share(const image::Image& picture, const image::Image& cutout) {
  Mean share;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (nearest_pixel(cutout, x, y)[3] < 255 || !is_near_background(cutout, x, y)) continue;
      Mean body, beside;
      for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
          const int alpha = nearest_pixel(cutout, x + dx, y + dy)[3];
          const double seen = luminance(nearest_pixel(picture, x + dx, y + dy));
          if (alpha == 255) body.add(seen);
          if (alpha == 0) beside.add(seen);
        }
      }
      const auto [dark, bright] = std::minmax({body.value(), beside.value()});
      share.add((bright + 0.05) / (dark + 0.05) >= 1.3 ? 1 : 0);
    }
  }
  return share.value();
}

class Light : public testing::TestWithParam<scene::Theme> {};

TEST_P(Light, SeparatesTheOutlineFromTheBackgroundAndClipsNoHighlight) {
  if (has_sanitizers) GTEST_SKIP() << "draws the same as other tests";
  const std::vector<image::Image> pictures = film(GetParam(), false);
  const std::vector<image::Image> cutouts = film(GetParam(), true);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    EXPECT_GE(visible_share(pictures[i], cutouts[i]), 0.95) << "frame " << 5 + 50 * i;
    int body = 0, clipped = 0;
    for (std::size_t k = 0; k < cutouts[i].pixels.size(); k += 4) {
      if (cutouts[i].pixels[k + 3] < 255) continue;
      ++body;
      const std::uint8_t* const p = &cutouts[i].pixels[k];
      clipped += std::min({p[0], p[1], p[2]}) == 255 ? 1 : 0;
    }
    EXPECT_LE(clipped, body / 1000) << "frame " << 5 + 50 * i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Themes, Light, testing::Values(scene::Theme::studio, scene::Theme::paper, scene::Theme::space),
    [](const auto& theme) { return std::string(enumerator_name(theme.param)); });

}  // namespace
}  // namespace twrench::draw
