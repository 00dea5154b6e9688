#include <gtest/gtest.h>

#include <cstdlib>

#include "draw/exposure.h"

namespace twrench::draw {
namespace {

image::Image levels(int channels, int shift) {
  image::Image image(16, 16, channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(i * 7 + static_cast<std::size_t>(shift));
  }
  return image;
}

TEST(CrossFade, ChangesFromOnePictureToTheOther) {
  for (const int channels : {3, 4}) {
    image::Image from = levels(channels, 0), to = levels(channels, 90);
    for (std::size_t i = 3; channels == 4 && i < from.pixels.size(); i += 4) {
      from.pixels[i] = to.pixels[i] = 255;
    }
    EXPECT_EQ(cross_fade(from, to, 0).pixels, from.pixels);
    EXPECT_EQ(cross_fade(from, to, 1).pixels, to.pixels);
    EXPECT_EQ(cross_fade(from, from, 0.37).pixels, from.pixels) << "equal pixels are unchanged";
  }
}

TEST(CrossFade, IsTheMeanOfTheLight) {
  image::Image black(1, 1, 3), white(1, 1, 3);
  white.pixels.assign(3, 255);
  // The sRGB codes of half and of a fifth of the light.
  EXPECT_EQ(cross_fade(black, white, 0.5).pixels[0], 188);
  EXPECT_EQ(cross_fade(black, white, 0.2).pixels[0], 124);
}

TEST(CrossFade, KeepsTheColourOfWhatFadesIntoNothing) {
  image::Image red(1, 1, 4), nothing(1, 1, 4);
  red.pixels = {200, 30, 40, 255};
  nothing.pixels = {0, 255, 0, 0};
  const image::Image faded = cross_fade(red, nothing, 0.25);
  EXPECT_EQ(faded.pixels, (std::vector<std::uint8_t>{200, 30, 40, 191}));
}

}  // namespace
}  // namespace twrench::draw
