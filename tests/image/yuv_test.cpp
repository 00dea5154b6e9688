#include "image/yuv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace twrench::image {
namespace {

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height, 3);
  for (std::uint8_t& value : image.pixels) value = static_cast<std::uint8_t>(random() & 255U);
  return image;
}

std::vector<std::uint8_t> converted(const Image& image) {
  Yuv420 yuv(image.width, image.height);
  yuv.update(image, {0, 0, image.width, image.height});
  return {yuv.bytes().begin(), yuv.bytes().end()};
}

/// Y', Cb, Cr of BT.709 in 8-bit levels, unrounded: ITU-R BT.709-6, items 3.2 to 3.4.
std::array<double, 3> reference(const std::array<double, 3>& rgb) {
  const double y = (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]) / 255;
  return {16 + 219 * y, 128 + 224 * (rgb[2] / 255 - y) / 1.8556,
          128 + 224 * (rgb[0] / 255 - y) / 1.5748};
}

/// The mean colour around the chroma sample (cx, cy): columns weighted 1 2 1, two rows, with the
/// edge repeated outside.
std::array<double, 3> around(const Image& image, int cx, int cy) {
  std::array<double, 3> sum{};
  for (int row = 2 * cy; row <= 2 * cy + 1; ++row) {
    for (int step = -1; step <= 1; ++step) {
      const int x = std::clamp(2 * cx + step, 0, image.width - 1);
      const int y = std::min(row, image.height - 1);
      for (std::size_t i = 0; i < 3; ++i) {
        sum[i] += (step == 0 ? 2 : 1) / 8.0 *
                  image.pixels[static_cast<std::size_t>(3 * (y * image.width + x)) + i];
      }
    }
  }
  return sum;
}

// Half a level is rounding; the integer weights add a hundredth.
constexpr double tolerance = 0.51;

class Yuv : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Yuv, IsTheReferenceRounded) {
  const auto [width, height] = GetParam();
  const Image image = noise(width, height, 1);
  const auto bytes = converted(image);
  const int half_width = (width + 1) / 2, half_height = (height + 1) / 2;
  ASSERT_EQ(bytes.size(), static_cast<std::size_t>(width * height + 2 * half_width * half_height));
  for (int i = 0; i < width * height; ++i) {
    const std::uint8_t* p = &image.pixels[static_cast<std::size_t>(3 * i)];
    const double y = reference({double(p[0]), double(p[1]), double(p[2])})[0];
    ASSERT_NEAR(bytes[static_cast<std::size_t>(i)], y, tolerance) << i;
  }
  for (int cy = 0; cy < half_height; ++cy) {
    for (int cx = 0; cx < half_width; ++cx) {
      const auto expected = reference(around(image, cx, cy));
      const auto at = static_cast<std::size_t>(width * height + cy * half_width + cx);
      const auto plane = static_cast<std::size_t>(half_width * half_height);
      ASSERT_NEAR(bytes[at], expected[1], tolerance) << cx << ' ' << cy;
      ASSERT_NEAR(bytes[at + plane], expected[2], tolerance) << cx << ' ' << cy;
    }
  }
}

TEST_P(Yuv, UpdatedInAreasIsTheSameAsAtOnce) {
  const auto [width, height] = GetParam();
  std::mt19937 random(2);
  const auto below = [&](int bound) {
    return static_cast<int>(random() % static_cast<unsigned>(bound));
  };
  Image image = noise(width, height, 3);
  Yuv420 yuv(width, height);
  yuv.update(image, {0, 0, width, height});
  for (int i = 0; i < 50; ++i) {
    const int x = below(width), y = below(height);
    const Area area{x, y, 1 + below(width - x), 1 + below(height - y)};
    const Image other = noise(width, height, 10U + static_cast<unsigned>(i));
    for (int row = area.y; row < area.y + area.height; ++row) {
      const auto begin = static_cast<std::ptrdiff_t>(3 * (row * width + area.x));
      std::copy_n(other.pixels.begin() + begin, 3 * area.width, image.pixels.begin() + begin);
    }
    yuv.update(image, area);
    const auto whole = converted(image);
    ASSERT_TRUE(std::ranges::equal(yuv.bytes(), whole))
        << area.x << ' ' << area.y << ' ' << area.width << ' ' << area.height;
  }
}

INSTANTIATE_TEST_SUITE_P(OfSize, Yuv,
                         testing::Values(std::pair{64, 48}, std::pair{33, 17}, std::pair{1, 1},
                                         std::pair{2, 5}, std::pair{7, 2}),
                         [](const auto& param) {
                           return std::to_string(param.param.first) + "x" +
                                  std::to_string(param.param.second);
                         });

TEST(YuvLevels, BlackWhiteAndGrayAreExact) {
  for (const auto& [level, luma] : {std::pair{0, 16}, {255, 235}}) {
    Image image(4, 4, 3);
    std::ranges::fill(image.pixels, static_cast<std::uint8_t>(level));
    EXPECT_EQ(converted(image)[0], luma);
  }
  for (int level = 0; level < 256; ++level) {
    Image image(2, 2, 3);
    std::ranges::fill(image.pixels, static_cast<std::uint8_t>(level));
    const auto bytes = converted(image);
    EXPECT_EQ(bytes[4], 128) << level;
    EXPECT_EQ(bytes[5], 128) << level;
  }
}

}  // namespace
}  // namespace twrench::image
