#include "comparison/picture_pair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include "image/png.h"
#include "system/error.h"

namespace twrench::comparison {
namespace {

using testing::HasSubstr;

std::vector<std::uint8_t> gray(int width, int height, int changed_x = -1, int changed_y = 0) {
  image::Image image(width, height, 3);
  std::ranges::fill(image.pixels, std::uint8_t{100});
  if (changed_x >= 0)
    image.pixels[static_cast<std::size_t>(3 * (changed_y * width + changed_x))] = 90;
  return image::encode_png(image);
}

PicturePair pair_of(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  return {{a, "a.png"}, {b, "b.png"}};
}

TEST(PicturePair, ReportsDifferentFormats) {
  EXPECT_TRUE(pair_of(gray(10, 8), gray(10, 8)).same_format());
  const PicturePair pair = pair_of(gray(10, 8), gray(8, 10));
  EXPECT_FALSE(pair.same_format());
  EXPECT_EQ(pair.formats(), "10x8 with 3 channels, and 8x10 with 3");
}

// Each image would take a gigabyte.
TEST(PicturePair, RefusesAGiantPictureWithNothingOnIt) {
  std::vector<std::uint8_t> giant = gray(10, 8);
  for (const std::size_t at : {18U, 22U}) giant[at] = 0x40;  // 16384 in IHDR
  try {
    pair_of(gray(10, 8), giant);
    FAIL();
  } catch (const system::FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot read b.png: it has 16394x16392 pixels in "));
  }
}

TEST(PicturePair, IgnoresWhatIsWithinTheAreas) {
  const auto differs = [](const image::Area& area) {
    PicturePair pair = pair_of(gray(10, 8), gray(10, 8, 4, 2));
    pair.ignore({&area, 1});
    return pair.difference(0, 0).max > 0;
  };
  EXPECT_FALSE(differs({4, 2, 1, 1}));
  EXPECT_FALSE(differs({0, 0, 10, 7}));
  for (const image::Area& beside :
       {image::Area{3, 2, 1, 1}, {5, 2, 1, 1}, {4, 1, 1, 1}, {4, 3, 1, 1}, {0, 0, 4, 8}}) {
    EXPECT_TRUE(differs(beside)) << beside.x << "," << beside.y;
  }
}

TEST(PicturePair, RefusesAreasOutsideOfTheImage) {
  const std::vector<image::Area> outside{{9, 0, 2, 1}, {0, 7, 1, 2}, {10, 0, 1, 1}};
  for (const image::Area& area : outside) {
    try {
      PicturePair pair = pair_of(gray(10, 8), gray(10, 8));
      pair.ignore({&area, 1});
      ADD_FAILURE() << area.x << "," << area.y;
    } catch (const InvalidArgument& error) {
      EXPECT_THAT(error.what(), HasSubstr("is not within b.png, which has 10x8 pixels"));
    }
  }
}

TEST(PicturePair, RefusesToIgnoreTheWholeImage) {
  const image::Area whole{0, 0, 10, 8};
  EXPECT_THAT(
      [&] {
        pair_of(gray(10, 8), gray(10, 8)).ignore({&whole, 1});
      },
      testing::ThrowsMessage<InvalidArgument>(HasSubstr("nothing is left to compare")));
}

TEST(PicturePair, NamesTheFileThatIsDamaged) {
  auto cut = gray(10, 8);
  cut.resize(cut.size() - 30);
  EXPECT_THAT([&] { pair_of(gray(10, 8), cut); },
              testing::ThrowsMessage<system::FileError>(HasSubstr("cannot read b.png")));
}

}  // namespace
}  // namespace twrench::comparison
