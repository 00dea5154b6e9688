#include "image/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "image/sample_image.h"

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

TEST(Compare, ReportsItsPlace) {
  const Image a = flat(5, 4, 3, 100);
  Image b = a;
  EXPECT_EQ(compare(a, b, 0)->area, Area());
  b.pixels[3 * (1 * 5 + 3)] = 110;
  EXPECT_EQ(compare(a, b, 0)->area, (Area{3, 1, 1, 1}));
  b.pixels[3 * (3 * 5 + 1) + 2] = 105;
  EXPECT_EQ(compare(a, b, 0)->area, (Area{1, 1, 3, 3}));
  EXPECT_EQ(compare(a, b, 5)->area, (Area{3, 1, 1, 1}));
}

/// Two flat halves, separated after `column` columns by one column of the value `between`.
Image edge(int column, std::uint8_t between) {
  Image image = flat(12, 6, 3, 20);
  for (int y = 0; y < 6; ++y) {
    for (int x = column; x < 12; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.pixels[static_cast<std::size_t>((y * 12 + x) * 3 + c)] = x == column ? between : 200;
      }
    }
  }
  return image;
}

TEST(Compare, EdgesMayLieElsewhereHoweverAntialiased) {
  for (const std::uint8_t between : std::initializer_list<std::uint8_t>{20, 60, 130, 200}) {
    const Image a = edge(5, 100), b = edge(5, between), moved = edge(6, between);
    EXPECT_EQ(compare(a, b, 0, 1)->max, 0) << int{between};
    EXPECT_EQ(compare(b, a, 0, 1)->max, 0) << int{between};
    EXPECT_EQ(compare(a, moved, 0, 2)->max, 0) << int{between};
  }
  EXPECT_EQ(compare(edge(5, 200), edge(7, 200), 0, 1)->max, 180);
  EXPECT_EQ(compare(edge(5, 200), edge(7, 200), 0, 2)->max, 0);
}

// A pixel among neighbours like the background would be overlooked if only one image were compared
// with the other.
TEST(Compare, NoToleranceForEdgesHidesWhatIsInOneImageAlone) {
  const Image a = flat(9, 9, 3, 100);
  for (const std::size_t pixel : {0U, 8U, 40U, 72U, 80U}) {
    Image b = a;
    b.pixels[3 * pixel] = 140;
    for (const auto& difference : {compare(a, b, 0, 2), compare(b, a, 0, 2)}) {
      EXPECT_EQ(difference->max, 40) << pixel;
      EXPECT_DOUBLE_EQ(difference->share, 1.0 / 81) << pixel;
    }
  }
}

/// The distance of a sample from the range of its neighbours in the other image, or the reverse,
/// whichever is larger, as documented.
int edge_difference(const Image& a, const Image& b, int x, int y, int c, int radius) {
  const auto at = [&](const Image& image, int i, int j) {
    return int{image.pixels[static_cast<std::size_t>((j * image.width + i) * image.channels + c)]};
  };
  const auto outside = [&](const Image& one, const Image& other) {
    int low = 255, high = 0;
    for (int j = std::max(y - radius, 0); j <= std::min(y + radius, a.height - 1); ++j) {
      for (int i = std::max(x - radius, 0); i <= std::min(x + radius, a.width - 1); ++i) {
        low = std::min(low, at(other, i, j));
        high = std::max(high, at(other, i, j));
      }
    }
    return std::max({low - at(one, x, y), at(one, x, y) - high, 0});
  };
  return std::max(outside(a, b), outside(b, a));
}

TEST(Compare, TheToleranceForEdgesIsTheSameEverywhere) {
  for (const int channels : {3, 4}) {
    const Image a = sample_image(13, 7, channels, 1);
    Image b = sample_image(13, 7, channels, 2);
    for (std::size_t i = 0; i < b.pixels.size(); i += 5) b.pixels[i] ^= 0x1F;
    for (const int radius : {1, 2, 9, 16}) {
      double sum = 0;
      for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 13; ++x) {
          for (int c = 0; c < channels; ++c) sum += edge_difference(a, b, x, y, c, radius);
        }
      }
      EXPECT_DOUBLE_EQ(compare(a, b, 0, radius)->mean, sum / (13 * 7 * channels)) << radius;
    }
  }
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
