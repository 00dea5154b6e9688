#include "picture/compose/layer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "sanitizers.h"

namespace twrench::picture {
namespace {

using testing::Each;
using testing::ElementsAre;

Layer layer_of(std::vector<std::uint8_t> rgba, int x = 0, int y = 0) {
  Layer layer{image::Image(static_cast<int>(rgba.size() / 4), 1, 4), x, y};
  layer.image.pixels = std::move(rgba);
  return layer;
}

TEST(LayOver, CoversBlendsAndLeaves) {
  image::Image image(4, 2, 3);
  image.pixels.assign(image.pixels.size(), 100);
  const Layer layer = layer_of({200, 10, 0, 255, 100, 5, 0, 128, 0, 0, 0, 0}, 1, 1);
  composite_over(image, layer);
  const std::vector<std::uint8_t> top(image.pixels.begin(), image.pixels.begin() + 12);
  const std::vector<std::uint8_t> low(image.pixels.begin() + 12, image.pixels.end());
  EXPECT_THAT(top, Each(100));
  EXPECT_THAT(low, ElementsAre(100, 100, 100, 200, 10, 0, 150, 55, 50, 100, 100, 100));
}

// The rows have several lengths, because long ones are composited several pixels at a time.
TEST(LayOver, RoundsToTheNearest) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  for (const int width : {1, 5, 6, 23}) {
    const auto pixels = static_cast<std::size_t>(width);
    for (int alpha = 0; alpha <= 255; ++alpha) {
      for (int below = 0; below <= 255; ++below) {
        image::Image image(width, 1, 3);
        image.pixels.assign(3 * pixels, static_cast<std::uint8_t>(below));
        std::vector<std::uint8_t> rgba(4 * pixels);
        for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = static_cast<std::uint8_t>(alpha);
        composite_over(image, layer_of(rgba));
        ASSERT_THAT(image.pixels, Each(std::lround(below * (255 - alpha) / 255.0)));
      }
    }
  }
}

TEST(LayOver, BlendsEachPixelOfARow) {
  std::mt19937 random(1);
  for (int width = 1; width < 40; ++width) {
    image::Image image(width, 1, 3);
    for (std::uint8_t& value : image.pixels) value = static_cast<std::uint8_t>(random() % 256);
    std::vector<std::uint8_t> rgba;
    for (int x = 0; x < width; ++x) {
      const auto alpha = std::array{0U, 255U, static_cast<unsigned>(random() % 256)}[random() % 3];
      for (int c = 0; c < 3; ++c) rgba.push_back(static_cast<std::uint8_t>(random() % (alpha + 1)));
      rgba.push_back(static_cast<std::uint8_t>(alpha));
    }
    const std::vector<std::uint8_t> before = image.pixels;
    composite_over(image, layer_of(rgba));
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::size_t pixel = 4 * (i / 3);
      const long below = std::lround(before[i] * (255 - rgba[pixel + 3]) / 255.0);
      ASSERT_EQ(image.pixels[i], std::min(rgba[pixel + i % 3] + below, 255L)) << width << " " << i;
    }
  }
}

TEST(LayOver, AddsUpCoverage) {
  image::Image image(2, 1, 4);
  image.pixels = {0, 0, 0, 0, 100, 0, 0, 100};
  composite_over(image, layer_of({10, 20, 30, 128, 0, 0, 0, 51}));
  EXPECT_THAT(image.pixels, ElementsAre(10, 20, 30, 128, 80, 0, 0, 131));
}

TEST(LayOver, SaysWhereTheLayerLies) {
  image::Image image(4, 2, 3);
  EXPECT_EQ(composite_over(image, layer_of(std::vector<std::uint8_t>(8), 2, 1)),
            (std::vector{image::Area{2, 1, 2, 1}}));
}

TEST(LayerAround, EndsAtThePicturesEdges) {
  const image::Area picture{0, 0, 20, 10};
  EXPECT_EQ(layer_around({5, 4, 3, 2}, 2, picture).area(), (image::Area{3, 2, 7, 6}));
  EXPECT_EQ(layer_around({5, 4, 3, 2}, 8, picture).area(), (image::Area{0, 0, 16, 10}));
  EXPECT_EQ(layer_around({30, 4, 3, 2}, 2, picture).image.pixels.size(), 0U);
}

// This is an assertion if assertions are enabled. Otherwise the part inside is composited, and
// nothing else is changed.
TEST(LayOverDeathTest, CutsOffWhatLeavesThePicture) {
  for (const auto& [x, y] : {std::pair(-1, 0), {2, 0}, {0, -1}, {0, 3}, {-9, -9}, {9, 9}}) {
    image::Image image(4, 3, 3);
    const Layer layer = layer_of(std::vector<std::uint8_t>(16, 255), x, y);
    EXPECT_DEBUG_DEATH(composite_over(image, layer), "leaves the picture");
    const auto changed = std::ranges::count(image.pixels, 255);
    const image::Area seen = image::common(layer.area(), {0, 0, 4, 3});
    EXPECT_TRUE(changed == 0 || changed == 3L * seen.width * seen.height) << x << " " << y;
  }
}

TEST(MakeStraight, DividesByTheCoverageWithinTheArea) {
  image::Image image(4, 1, 4);
  image.pixels = {9, 9, 9, 18, 200, 100, 50, 255, 100, 50, 25, 128, 0, 0, 0, 0};
  unpremultiply(image, {1, 0, 3, 1});
  EXPECT_THAT(image.pixels,
              ElementsAre(9, 9, 9, 18, 200, 100, 50, 255, 199, 100, 50, 128, 0, 0, 0, 0));
}

}  // namespace
}  // namespace twrench::picture
