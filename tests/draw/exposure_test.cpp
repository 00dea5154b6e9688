#include "draw/exposure.h"

#include <gtest/gtest.h>

namespace twrench::draw {
namespace {

image::Image pixel(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
  image::Image image(1, 1, 4);
  image.pixels = {r, g, b, a};
  return image;
}

std::vector<std::uint8_t> mean(const std::vector<image::Image>& images) {
  Exposure exposure(1, 1);
  for (const image::Image& image : images) exposure.add(image);
  return exposure.mean().pixels;
}

using Pixel = std::vector<std::uint8_t>;

TEST(Exposure, OfOnePictureIsThatPicture) {
  for (int level = 0; level < 256; ++level) {
    const auto v = static_cast<std::uint8_t>(level);
    const Pixel result = mean({pixel(v, v, v, 255)});
    EXPECT_NEAR(result[0], level, level < 10 ? 1 : 0);
    EXPECT_EQ(result[3], 255);
  }
  EXPECT_EQ(mean({pixel(50, 40, 30, 100)}), (Pixel{50, 40, 30, 100}));
  EXPECT_EQ(mean({pixel(0, 0, 0, 0)}), (Pixel{0, 0, 0, 0}));
}

TEST(Exposure, TakesTheMeanOfTheLight) {
  // Level 188 of sRGB has half the light of white (IEC 61966-2-1).
  EXPECT_EQ(mean({pixel(255, 0, 0, 255), pixel(0, 255, 0, 255)}), (Pixel{188, 188, 0, 255}));
}

TEST(Exposure, KeepsTheColourWhereTheCoverageIsPartial) {
  EXPECT_EQ(mean({pixel(200, 100, 50, 255), pixel(0, 0, 0, 0)}), (Pixel{100, 50, 25, 128}));
}

}  // namespace
}  // namespace twrench::draw
