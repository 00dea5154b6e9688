#include "comparison/picture_pair.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <isa-l/crc.h>
#include <twrench/base/error.h>

#include "image/png.h"
#include "run_command.h"
#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"

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

/// A picture of 4x4 pixels whose first one has these samples.
std::vector<std::uint8_t> picture(const std::vector<std::uint8_t>& first,
                                  std::uint8_t alpha = 255) {
  image::Image image(4, 4, static_cast<int>(first.size()));
  std::ranges::fill(image.pixels, std::uint8_t{100});
  for (std::size_t at = 3; first.size() == 4 && at < image.pixels.size(); at += 4) {
    image.pixels[at] = alpha;
  }
  std::ranges::copy(first, image.pixels.begin());
  return image::encode_png(image);
}

/// The same PNG file with a chunk before its data.
std::vector<std::uint8_t> with_chunk(std::vector<std::uint8_t> png, const std::string& type,
                                     const std::vector<std::uint8_t>& data) {
  const auto big_endian = [](std::uint32_t number) {
    return std::vector{std::uint8_t(number >> 24U), std::uint8_t(number >> 16U),
                       std::uint8_t(number >> 8U), std::uint8_t(number)};
  };
  std::vector<std::uint8_t> checked(type.begin(), type.end());
  checked.insert(checked.end(), data.begin(), data.end());
  std::vector<std::uint8_t> chunk = big_endian(static_cast<std::uint32_t>(data.size()));
  chunk.insert(chunk.end(), checked.begin(), checked.end());
  const auto sum = big_endian(crc32_gzip_refl(0, checked.data(), checked.size()));
  chunk.insert(chunk.end(), sum.begin(), sum.end());
  constexpr std::ptrdiff_t header_end = 33;
  png.insert(png.begin() + header_end, chunk.begin(), chunk.end());
  return png;
}

TEST(PicturePair, IgnoresAnAlphaChannelThatIsOpaque) {
  const auto rgb = picture({1, 2, 3}), rgba = picture({1, 2, 3, 255});
  const PicturePair one = pair_of(rgb, rgba), other = pair_of(rgba, rgb);
  for (const PicturePair* pair : {&one, &other}) {
    ASSERT_TRUE(pair->same_format());
    EXPECT_EQ(pair->difference(0, 0).max, 0);
  }
  EXPECT_THAT(one.notes(), testing::ElementsAre(HasSubstr("the actual picture has an alpha")));
  EXPECT_THAT(other.notes(), testing::ElementsAre(HasSubstr("the expected picture has an alpha")));
  EXPECT_EQ(pair_of(rgb, picture({1, 2, 9, 255})).difference(0, 0).max, 6);
  // One pixel is not opaque.
  const PicturePair different = pair_of(rgb, picture({1, 2, 3, 254}));
  EXPECT_FALSE(different.same_format());
  EXPECT_THAT(different.notes(), testing::IsEmpty());
}

TEST(PicturePair, IgnoresTheColoursOfInvisiblePixels) {
  const PicturePair hidden = pair_of(picture({1, 2, 3, 0}), picture({200, 2, 3, 0}));
  EXPECT_EQ(hidden.difference(0, 0).max, 0);
  EXPECT_EQ(hidden.difference(0, 1).max, 0);
  EXPECT_THAT(hidden.notes(), testing::ElementsAre("the colours of invisible pixels differ"));
  EXPECT_THAT(pair_of(picture({1, 2, 3, 0}), picture({1, 2, 3, 0})).notes(), testing::IsEmpty());
  EXPECT_EQ(pair_of(picture({1, 2, 3, 0}), picture({1, 2, 3, 9})).difference(0, 0).max, 9);
  EXPECT_EQ(pair_of(picture({1, 2, 3, 1}), picture({200, 2, 3, 1})).difference(0, 0).max, 199);
}

// The pictures have 16 bits, and each sample is that of 8 bits times 257.
TEST(PicturePair, IgnoresThatTheBitsAreMoreIfTheValuesAreTheSame) {
  const ScratchFolder folder;
  const auto deep = [&](int low_byte) {
    const std::string file = (folder / "deep.png").string();
    run_command(
        fmt::format("printf 'P7\\nWIDTH 1\\nHEIGHT 1\\nDEPTH 3\\nMAXVAL 65535\\nTUPLTYPE "
                    "RGB\\nENDHDR\\n\\001\\001\\002\\002\\003\\00{}' | ffmpeg -v error -y "
                    "-f image2pipe -c:v pam -i - -pix_fmt rgb48be '{}'",
                    low_byte, file));
    return system::read_file(file, 10'000);
  };
  image::Image image(1, 1, 3);
  image.pixels = {1, 2, 3};
  const auto shallow = image::encode_png(image);
  const PicturePair equal = pair_of(shallow, deep(3));
  EXPECT_EQ(equal.difference(0, 0).max, 0);
  EXPECT_THAT(equal.notes(), testing::ElementsAre(
                                 "the expected picture has 8 bits per channel, the actual one 16"));
  EXPECT_GT(pair_of(shallow, deep(4)).difference(0, 0).max, 0);
}

TEST(PicturePair, NotesOtherDescriptionsOfColours) {
  const auto plain = picture({1, 2, 3});
  const auto gamma = with_chunk(plain, "gAMA", {0, 0, 0xB1, 0x8F});
  const PicturePair pair = pair_of(plain, gamma);
  EXPECT_EQ(pair.difference(0, 0).max, 0);
  EXPECT_THAT(pair.notes(), testing::ElementsAre(
                                "the descriptions of colours differ (gAMA); they are not applied"));
  EXPECT_THAT(pair_of(gamma, gamma).notes(), testing::IsEmpty());
  EXPECT_THAT(pair_of(gamma, with_chunk(plain, "gAMA", {0, 1, 0x86, 0xA0})).notes(),
              testing::SizeIs(1));
  const auto space = with_chunk(gamma, "sRGB", {0});
  EXPECT_THAT(pair_of(plain, space).notes(), testing::ElementsAre(HasSubstr("(gAMA, sRGB)")));
  EXPECT_THAT(pair_of(plain, with_chunk(plain, "tEXt", {'a', 0, 'b'})).notes(), testing::IsEmpty());
}

// Bytes of another file at the place of the size look like a giant picture.
TEST(PicturePair, NamesAFileThatIsNoPng) {
  std::vector<std::uint8_t> jpeg(1044, 0xFF);
  const std::string start("\xFF\xD8\xFF\xE0", 4);
  std::ranges::copy(start, jpeg.begin());
  EXPECT_THAT([&] { pair_of(gray(10, 8), jpeg); },
              testing::ThrowsMessage<system::FileError>(
                  "cannot read b.png: it is a JPEG picture, not a PNG image"));
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
