// Tests that the surface does not sparkle: under a slow motion the light of each pixel varies
// slowly.
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "base/enumeration.h"
#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "picture/t_wrench.h"
#include "sanitizers.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Sixty pictures of the body alone, which turns by a twentieth of a degree between them. No point
/// of it moves by more than a third of a pixel.
std::vector<image::Image> slow_motion(gl::Context& context, scene::Theme theme, const Matrix3d& X,
                                      const Vector3d& axis) {
  scene::Scene scene = picture::t_wrench(960, 540);
  scene.look.theme = theme;
  scene.look.transparent = true;
  PoseRenderer renderer(context, scene);
  std::vector<image::Image> images;
  for (int i = 0; i < 60; ++i) images.push_back(renderer.draw(so3::exp(9e-4 * i * axis) * X));
  return images;
}

/// Whether the pixel and its neighbours belong to the body.
bool is_inside(const image::Image& image, int x, int y) {
  const int width = image.width, height = image.height;
  constexpr int margin = 2;
  if (x < margin || y < margin || x >= width - margin || y >= height - margin) return false;
  for (int dy = -margin; dy <= margin; ++dy) {
    for (int dx = -margin; dx <= margin; ++dx) {
      if (image.pixels[4 * static_cast<std::size_t>((y + dy) * width + x + dx) + 3] < 255) {
        return false;
      }
    }
  }
  return true;
}

/// The number of pixels that change by more than 40 of 255 and back again within three pictures.
int sparks(const std::vector<image::Image>& images) {
  const int width = images.front().width, height = images.front().height;
  int count = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!is_inside(images.front(), x, y) || !is_inside(images.back(), x, y)) continue;
      const auto green = [&](std::size_t i) {
        return int{images[i].pixels[4 * static_cast<std::size_t>(y * width + x) + 1]};
      };
      for (std::size_t i = 0; i + 3 < images.size(); ++i) {
        const int up = green(i + 1) - green(i);
        if (std::abs(up) <= 40) continue;
        const auto returns = [&](std::size_t k) {
          const int change = green(i + k) - green(i + 1);
          return up > 0 ? change < -40 : change > 40;
        };
        if (returns(2) || returns(3)) {
          ++count;
          break;
        }
      }
    }
  }
  return count;
}

class Steadiness : public testing::TestWithParam<scene::Theme> {};

TEST_P(Steadiness, OfTheLightOnABodyThatTurnsSlowly) {
  if (has_sanitizers) GTEST_SKIP() << "draws the same as other tests";
  const std::unique_ptr<gl::Context> context = gl::make_test_context();
  for (const Vector3d& start : {Vector3d(0.3, 0.2, 0.1), Vector3d(1.2, -0.7, 0.4)}) {
    for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(0.6, 0.8, 0)}) {
      // A bevel is a line one or two pixels wide, and single pixels of it may differ by 42.
      EXPECT_LE(sparks(slow_motion(*context, GetParam(), so3::exp(start), axis)), 2)
          << "from " << start.transpose() << " about " << axis.transpose();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Themes, Steadiness,
                         testing::Values(scene::Theme::studio, scene::Theme::paper,
                                         scene::Theme::space),
                         [](const auto& theme) {
                           return std::string(enumerator_name(theme.param));
                         });

}  // namespace
}  // namespace twrench::draw
