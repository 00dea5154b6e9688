#include "image/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace twrench::image {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

Image flat(int width, int height, int channels, std::uint8_t value) {
  Image image(width, height, channels);
  for (std::uint8_t& p : image.pixels) {
    p = value;
  }
  return image;
}

TEST(Compare, EqualImagesDoNotDiffer) {
  const Image image = flat(4, 3, 3, 77);
  const auto difference = compare(image, image, 0);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->max, 0);
  EXPECT_EQ(difference->mean, 0.0);
  EXPECT_EQ(difference->share, 0.0);
}

TEST(Compare, MaxMeanAndShare) {
  const Image a = flat(5, 2, 3, 100);
  Image b = a;
  b.pixels[0] = 90;    // pixel 0: 10 below
  b.pixels[2] = 102;   // and 2 above
  b.pixels[29] = 104;  // pixel 9: 4 above
  for (const auto& difference : {compare(a, b, 3), compare(b, a, 3)}) {
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->max, 10);
    EXPECT_DOUBLE_EQ(difference->mean, 16.0 / 30);
    EXPECT_DOUBLE_EQ(difference->share, 0.2);
  }
  EXPECT_DOUBLE_EQ(compare(a, b, 4)->share, 0.1);
  EXPECT_DOUBLE_EQ(compare(a, b, 10)->share, 0.0);
}

TEST(Compare, BlackAndWhiteAreFarthestApart) {
  const auto difference = compare(flat(2, 2, 4, 0), flat(2, 2, 4, 255), 254);
  EXPECT_EQ(difference->max, 255);
  EXPECT_DOUBLE_EQ(difference->mean, 255.0);
  EXPECT_DOUBLE_EQ(difference->share, 1.0);
}

TEST(Compare, AlphaCounts) {
  Image a = flat(2, 1, 4, 9);
  Image b = a;
  b.pixels[7] = 12;
  EXPECT_EQ(compare(a, b, 0)->max, 3);
  EXPECT_THAT(difference_image(a, b).pixels, ElementsAre(0, 0, 0, 255, 255, 255));
}

TEST(Compare, SixteenBitsTellPartsOfAStep) {
  DeepImage a(2, 1, 3);
  DeepImage b = a;
  b.pixels[4] = 1;  // of 257 in a step
  EXPECT_DOUBLE_EQ(compare(a, b, 0)->max, 1.0 / 257);
  EXPECT_DOUBLE_EQ(compare(a, b, 0)->mean, 1.0 / 257 / 6);
  EXPECT_DOUBLE_EQ(compare(a, b, 0)->share, 0.5);
  EXPECT_DOUBLE_EQ(compare(a, b, 1)->share, 0.0);
  EXPECT_THAT(difference_image(a, b).pixels, ElementsAre(0, 0, 0, 0, 255, 0));
}

TEST(Compare, OtherSizesAndChannelsHaveNoDifference) {
  const Image image = flat(4, 3, 3, 0);
  EXPECT_FALSE(compare(image, flat(3, 4, 3, 0), 0));
  EXPECT_FALSE(compare(image, flat(4, 4, 3, 0), 0));
  EXPECT_FALSE(compare(image, flat(4, 3, 4, 0), 0));
}

TEST(DifferenceImage, MakesTheLargestDifferenceWhite) {
  const Image a = flat(2, 1, 3, 50);
  Image b = a;
  b.pixels[0] = 52;
  b.pixels[4] = 49;
  EXPECT_THAT(difference_image(a, b).pixels, ElementsAre(255, 0, 0, 0, 127, 0));
}

TEST(DifferenceImage, OfEqualImagesIsBlack) {
  const Image image = flat(3, 2, 4, 200);
  EXPECT_THAT(difference_image(image, image).pixels, Each(0));
}

}  // namespace
}  // namespace twrench::image
