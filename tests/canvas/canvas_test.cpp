#include "canvas/canvas.h"

#include <gmock/gmock.h>

#include <future>

#include "canvas/font_bytes.h"

namespace twrench::canvas {
namespace {

using testing::Each;
using testing::ElementsAre;

constexpr Color ink{200, 100, 50};

std::vector<int> pixel(const image::Image& image, int x, int y) {
  const std::size_t at =
      static_cast<std::size_t>(y) * image.row_bytes() + 4 * static_cast<std::size_t>(x);
  return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2], image.pixels[at + 3]};
}

TEST(Canvas, FillsWholePixelsInThePicturesPlaces) {
  image::Image image(6, 4, 4);
  Canvas(image, 10, 20).rectangle(12, 21, 2, 1, {ink});
  EXPECT_THAT(pixel(image, 2, 1), ElementsAre(200, 100, 50, 255)) << "red first";
  EXPECT_THAT(pixel(image, 3, 1), ElementsAre(200, 100, 50, 255));
  for (const auto& [x, y] : {std::pair(1, 1), {4, 1}, {2, 0}, {2, 2}}) {
    EXPECT_THAT(pixel(image, x, y), Each(0)) << x << " " << y;
  }
}

TEST(Canvas, PremultipliesByOpacityAndCoverage) {
  image::Image image(2, 1, 4);
  Canvas(image, 0, 0).rectangle(0, 0, 1.5, 1, {ink, 0.5});
  const auto near = [](int value) {
    return testing::AllOf(testing::Ge(value - 2), testing::Le(value + 2));
  };
  EXPECT_THAT(pixel(image, 0, 0), ElementsAre(near(100), near(50), near(25), near(128)));
  EXPECT_THAT(pixel(image, 1, 0), ElementsAre(near(50), near(25), near(13), near(64)));
}

TEST(Canvas, WritesOnTheBaselineAlignedAsAsked) {
  const Typeface typeface = load_typeface("sans");
  const Line line = typeset(typeface.regular, "H");
  const double size = 30, width = size * line.width;
  const auto columns = [&](Canvas::Align align) {
    image::Image image(100, 60, 4);
    Canvas(image, 0, 0).text(line, size, {50, 40}, {ink}, align);
    int first = 100, last = 0, bottom = 0;
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 100; ++x) {
        if (pixel(image, x, y)[3] < 128) continue;
        first = std::min(first, x);
        last = std::max(last, x);
        bottom = y;
      }
    }
    EXPECT_EQ(bottom, 39);
    return (first + last + 1) / 2.0;  // the middle of the H
  };
  EXPECT_NEAR(columns(Canvas::Align::left), 50 + width / 2, 1);
  EXPECT_NEAR(columns(Canvas::Align::centre), 50, 1);
  EXPECT_NEAR(columns(Canvas::Align::right), 50 - width / 2, 1);
}

image::Image picture_of(const Line& line, double x, double y) {
  image::Image image(60, 40, 4);
  Canvas(image, 0, 0).text(line, 20, {x, y}, {ink});
  return image;
}

TEST(Canvas, DoesNotMoveLettersToWholePixels) {
  const Typeface typeface = load_typeface("sans");
  const Line line = typeset(typeface.regular, "H");
  for (const auto& [x, y] : {std::pair(10.125, 30.0), {10, 30.125}}) {
    EXPECT_NE(picture_of(line, x, y).pixels, picture_of(line, 10, 30).pixels) << x << " " << y;
  }
}

TEST(Canvas, DrawsEachGlyphWithItsFont) {
  const Typeface typeface = load_typeface("sans");
  const Font font = Font(many_scripts_file(U"k "), "F").with_fallback(typeface.regular);
  const Line line = typeset(font, "S k");
  image::Image one_by_one(60, 40, 4);
  Canvas canvas(one_by_one, 0, 0);
  canvas.text(typeset(typeface.regular, "S"), 20, {5, 30}, {ink});
  canvas.text(typeset(font, "k"), 20, {5 + 20 * line.glyphs.back().x, 30}, {ink});
  // If two letters are drawn at once, Cairo rounds their edges a little differently, and so do its
  // releases. A letter of another font or in another place changes whole pixels.
  const auto near = [](int a, int b) { return std::abs(a - b) <= 32; };
  EXPECT_TRUE(std::ranges::equal(picture_of(line, 5, 30).pixels, one_by_one.pixels, near));
}

TEST(Canvas, DrawsNothingForASpace) {
  const Typeface typeface = load_typeface("sans");
  EXPECT_THAT(picture_of(typeset(typeface.regular, " \u2007\u2009\u200D"), 10, 30).pixels, Each(0));
}

TEST(Canvas, DrawsTheSameFromSeveralThreads) {
  const Typeface typeface = load_typeface("sans");
  const auto draw = [&] {
    std::vector<image::Image> images;
    for (int i = 0; i < 20; ++i) {
      const Line line = typeset(typeface.regular, "−1.2×10⁻³ " + std::to_string(i));
      images.push_back(picture_of(line, 0.1 * i, 30));
    }
    return images;
  };
  auto beside = std::async(std::launch::async, draw);
  const std::vector<image::Image> here = draw(), there = beside.get();
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_EQ(here[i].pixels, there[i].pixels) << i;
}

TEST(Canvas, LaysTheHaloAroundTheLetters) {
  const Typeface typeface = load_typeface("sans");
  const Line line = typeset(typeface.regular, "I");
  image::Image image(40, 40, 4);
  Canvas(image, 0, 0).text_halo(line, 30, {10, 30}, 4, {ink});
  const int middle = static_cast<int>(10 + 30 * line.width / 2);
  EXPECT_EQ(pixel(image, middle, 32)[3], 255) << "below the foot of the I";
}

TEST(Canvas, RoundsThePanelsCorners) {
  image::Image image(40, 40, 4);
  Canvas(image, 0, 0).panel({10, 12, 20, 16}, 5, {ink, 0.8});
  EXPECT_EQ(pixel(image, 20, 20)[3], 204);
  EXPECT_EQ(pixel(image, 10, 20)[3], 204) << "whole up to its edges";
  EXPECT_EQ(pixel(image, 29, 20)[3], 204);
  EXPECT_EQ(pixel(image, 9, 20)[3], 0);
  EXPECT_EQ(pixel(image, 30, 20)[3], 0);
  for (const auto& [x, y] : {std::pair(10, 12), {29, 12}, {10, 27}, {29, 27}}) {
    EXPECT_EQ(pixel(image, x, y)[3], 0) << "the corner at " << x << ", " << y;
  }
}

}  // namespace
}  // namespace twrench::canvas
