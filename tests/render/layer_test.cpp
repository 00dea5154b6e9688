#include "render/layer.h"

#include <gmock/gmock.h>

#include <cmath>

namespace twrench {
namespace {

using testing::Each;
using testing::ElementsAre;

Image layer_of(std::vector<std::uint8_t> rgba) {
  Image layer(static_cast<int>(rgba.size() / 4), 1, 4);
  layer.pixels = std::move(rgba);
  return layer;
}

TEST(LayOver, CoversBlendsAndLeaves) {
  Image image(4, 2, 3);
  image.pixels.assign(image.pixels.size(), 100);
  const Image layer = layer_of({200, 10, 0, 255, 100, 5, 0, 128, 0, 0, 0, 0});
  lay_over(image, layer, 1, 1);
  const std::vector<std::uint8_t> top(image.pixels.begin(), image.pixels.begin() + 12);
  const std::vector<std::uint8_t> low(image.pixels.begin() + 12, image.pixels.end());
  EXPECT_THAT(top, Each(100));
  EXPECT_THAT(low, ElementsAre(100, 100, 100, 200, 10, 0, 150, 55, 50, 100, 100, 100));
}

TEST(LayOver, RoundsToTheNearest) {
  for (int alpha = 0; alpha <= 255; ++alpha) {
    for (int below = 0; below <= 255; ++below) {
      Image image(1, 1, 3);
      image.pixels.assign(3, static_cast<std::uint8_t>(below));
      lay_over(image, layer_of({0, 0, 0, static_cast<std::uint8_t>(alpha)}), 0, 0);
      ASSERT_EQ(image.pixels[0], std::lround(below * (255 - alpha) / 255.0));
    }
  }
}

TEST(LayOnNothing, GivesStraightColourAndClearSurroundings) {
  const Image layer = layer_of({200, 100, 50, 255, 100, 50, 25, 128, 0, 0, 0, 0});
  const Image image = lay_on_nothing(4, 1, layer, 1, 0);
  EXPECT_EQ(image.channels, 4);
  EXPECT_THAT(image.pixels,
              ElementsAre(0, 0, 0, 0, 200, 100, 50, 255, 199, 100, 50, 128, 0, 0, 0, 0));
}

}  // namespace
}  // namespace twrench
