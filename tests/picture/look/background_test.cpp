#include "picture/look/background.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace twrench::picture {
namespace {

/// Returns the mean of all channels over a row.
double mean_of_row(const image::Image& image, int y) {
  const auto begin = image.pixels.begin() + y * static_cast<std::ptrdiff_t>(image.row_bytes());
  return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(image.row_bytes()), 0.0) /
         static_cast<double>(image.row_bytes());
}

TEST(Background, IsExactlyTheFlatColour) {
  scene::Look look;
  look.background = Color{1, 200, 255};
  const image::Image image = background(look, 3, 2);
  ASSERT_EQ(image.pixels.size(), 18U);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    EXPECT_EQ(image.pixels[i], 1);
    EXPECT_EQ(image.pixels[i + 1], 200);
    EXPECT_EQ(image.pixels[i + 2], 255);
  }
}

TEST(Background, GoesFromDarkAboveToLighterBelow) {
  const image::Image image = background(scene::Look(), 320, 180);
  EXPECT_LT(mean_of_row(image, 0), 15);
  EXPECT_GT(mean_of_row(image, 179), 40);
  EXPECT_LT(mean_of_row(image, 179), 60);
}

TEST(Background, HasNoBands) {
  // Rows at most one 8-bit step apart differ in their mean by less than that step, because of
  // dithering.
  const image::Image image = background(scene::Look(), 1920, 1080);
  int equal = 0;
  for (int y = 300; y < 900; ++y) {
    const double step = mean_of_row(image, y + 1) - mean_of_row(image, y);
    EXPECT_LT(std::abs(step), 0.5) << "row " << y;
    if (step == 0) ++equal;
  }
  EXPECT_LT(equal, 6);
}

// A video has 8 bits of chroma. A hue that varied with the brightness would become visible as
// patches.
TEST(Background, HasTheSameHueEverywhere) {
  for (const scene::Theme theme : {scene::Theme::studio, scene::Theme::paper}) {
    scene::Look look;
    look.theme = theme;
    const image::Image image = background(look, 640, 360);
    const std::uint8_t* const first = image.pixels.data();
    std::size_t other = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
      const std::uint8_t* const p = first + i;
      if (p[0] - p[1] != first[0] - first[1] || p[2] - p[1] != first[2] - first[1]) ++other;
    }
    EXPECT_LE(other, image.pixels.size() / 3 / 1000)
        << "except for a few pixels, because of rounding";
  }
}

TEST(Background, HasTheSameStarsInEverySize) {
  scene::Look look;
  look.theme = scene::Theme::space;
  const image::Image small = background(look, 640, 360);
  const image::Image large = background(look, 1280, 720);
  const auto is_star = [](const image::Image& image, int x, int y) {
    return image.pixels[static_cast<std::size_t>(y) * image.row_bytes() +
                        static_cast<std::size_t>(x) * 3] > 60;
  };
  int stars = 0;
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 640; ++x) {
      if (!is_star(large, 2 * x, 2 * y)) continue;
      ++stars;
      EXPECT_GT(small.pixels[static_cast<std::size_t>(y) * small.row_bytes() +
                             static_cast<std::size_t>(x) * 3],
                20)
          << x << " " << y;
    }
  }
  EXPECT_GT(stars, 20);
}

TEST(Background, LeavesOutStarsThatWouldHaveToMove) {
  scene::Look look;
  look.theme = scene::Theme::space;
  const image::Image empty = background(look, 640, 360, false), all = background(look, 640, 360);
  EXPECT_LT(*std::ranges::max_element(empty.pixels), 32);
  EXPECT_GT(*std::ranges::max_element(all.pixels), 32);
}

}  // namespace
}  // namespace twrench::picture
