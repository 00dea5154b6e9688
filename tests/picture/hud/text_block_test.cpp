// Tests the positions of lines, bars and readouts in a text block. The expected widths are measured
// with the same font, so the tests are valid for every font.
#include "picture/hud/text_block.h"

#include <gtest/gtest.h>

namespace twrench::picture {
namespace {

constexpr image::Area whole_area{0, 0, 400, 300};
constexpr image::Area block_area{20, 30, 300, 200};
constexpr double size_of_readout = 20, size_of_caption = 10;

class TextBlockTest : public testing::Test {
 protected:
  TextBlock block(bool compact = false, const image::Area& within = block_area) const {
    return {{typeface_,
             style_of(scene::Theme::studio).overlay,
             {.title = 30, .readout = size_of_readout, .caption = size_of_caption},
             compact,
             false},
            within};
  }

  double width(const std::string& text, double size) const {
    return size * canvas::typeset(typeface_.regular, text).width;
  }

  Readout readout(const std::string& caption) const {
    return {caption, "0.0", [](const timeline::FrameState&) { return std::string("1.0"); }};
  }

  /// Returns the first and the last row of the picture in which the column `x` has this colour.
  static std::pair<int, int> rows_of(const Layer& layer, int x, const Color& color) {
    std::pair<int, int> rows{-1, -1};
    for (int y = 0; y < layer.image.height; ++y) {
      const std::ptrdiff_t place = std::ptrdiff_t{y} * layer.image.width + x - layer.x;
      const std::uint8_t* const pixel = layer.image.pixels.data() + 4 * place;
      if (pixel[0] != color.red || pixel[1] != color.green || pixel[2] != color.blue) continue;
      if (rows.first < 0) rows.first = y + layer.y;
      rows.second = y + layer.y;
    }
    return rows;
  }

  canvas::Typeface typeface_ = canvas::load_typeface("sans");
};

TEST_F(TextBlockTest, IsEmptyWithoutText) { EXPECT_TRUE(block().is_empty()); }

TEST_F(TextBlockTest, EndsBelowItsLines) {
  TextBlock lines = block();
  lines.add_line("one", typeface_.regular, 30, {});
  EXPECT_FALSE(lines.is_empty());
  EXPECT_EQ(lines.extent().height, 36);  // 1.2 em
  EXPECT_NEAR(lines.extent().width, width("one", 30), 1);
  lines.add_line("another", typeface_.regular, 20, {});
  EXPECT_EQ(lines.extent().height, 36 + 24);
}

// Two bars of 1.1 em, each 0.4 em thick.
TEST_F(TextBlockTest, PutsEachBarBelowTheOneBefore) {
  constexpr Color red{255, 0, 0}, blue{0, 0, 255};
  TextBlock bars = block();
  bars.add_bar(0.5, red);
  EXPECT_EQ(bars.extent(), (image::Area{block_area.x, block_area.y, 150, 22}));
  bars.add_bar(1, blue);
  EXPECT_EQ(bars.extent(), (image::Area{block_area.x, block_area.y, 300, 44}));
  bars.finish(whole_area);
  const Layer layer = bars.draw({});
  EXPECT_EQ(rows_of(layer, block_area.x + 10, red), (std::pair(36, 43)));
  EXPECT_EQ(rows_of(layer, block_area.x + 10, blue), (std::pair(58, 65)));
  EXPECT_EQ(rows_of(layer, block_area.x + 149, red).first, 36);
  EXPECT_EQ(rows_of(layer, block_area.x + 151, red).first, -1);
}

TEST_F(TextBlockTest, PutsReadoutsBelowABar) {
  TextBlock bare = block();
  bare.add_readouts({readout("speed")});
  TextBlock with_bar = block();
  with_bar.add_bar(0.1, {});
  with_bar.add_readouts({readout("speed")});
  EXPECT_EQ(bare.extent().height, 39);  // 1.25 em of the value and 1.4 em of the caption
  EXPECT_EQ(with_bar.extent().height, 22 + 39);
}

TEST_F(TextBlockTest, PutsCompactReadoutsInOneLine) {
  TextBlock text = block(true);
  text.add_readouts({readout("speed")});
  EXPECT_EQ(text.extent().height, 25);
  EXPECT_NEAR(text.extent().width,
              width("speed", size_of_caption) + 0.5 * size_of_readout + width("0.0", 20), 1);
}

TEST_F(TextBlockTest, StacksReadoutsInAnUprightArea) {
  TextBlock beside = block(), below = block(false, {20, 30, 150, 200});
  for (TextBlock* text : {&beside, &below}) text->add_readouts({readout("a"), readout("b")});
  EXPECT_EQ(beside.extent().height, 39);
  EXPECT_EQ(below.extent().height, 39 + 7 + 39);  // with a gap of 0.35 em
  EXPECT_NEAR(beside.extent().width, 2 * below.extent().width + 1.3 * size_of_readout, 2);
}

TEST_F(TextBlockTest, OmitsWhatHasNoRoom) {
  TextBlock low = block(false, {20, 30, 300, 38});
  low.add_readouts({readout("a")});  // 39 px: a pixel more is allowed
  EXPECT_EQ(low.extent().height, 39);
  low.add_line("below", typeface_.regular, 20, {});
  low.add_bar(1, {});
  low.add_remark("remark", {});
  EXPECT_EQ(low.extent().height, 39);
  TextBlock lower = block(false, {20, 30, 300, 37});
  lower.add_readouts({readout("a")});
  EXPECT_TRUE(lower.is_empty());
}

// A line that is too long is set smaller, but no smaller than a readout.
TEST_F(TextBlockTest, SetsALongLineSmaller) {
  const std::string text(15, 'm');
  const double fitting = width(text, 300 / width(text, 1));
  ASSERT_NEAR(fitting, 300, 1e-9);
  ASSERT_GT(300 / width(text, 1), size_of_readout) << "the font is unusually wide";
  TextBlock line = block();
  line.add_line(text, typeface_.regular, 60, {});
  EXPECT_EQ(line.extent().width, 300);
  EXPECT_EQ(line.extent().height, 72) << "the line keeps its height";
}

TEST_F(TextBlockTest, LeavesRoomForTheCorner) {
  TextBlock plain = block(), with_corner = block();
  with_corner.add_corner(readout("time"));
  EXPECT_EQ(with_corner.extent(), (image::Area{block_area.x, block_area.y, 300, 36}));
  const std::string text(200, 'm');
  for (TextBlock* line : {&plain, &with_corner}) {
    line->add_paragraph(text, typeface_.regular, 20, {});
  }
  EXPECT_EQ(plain.extent().height, 27);  // 1.35 em
  EXPECT_EQ(with_corner.extent().height, 36);
}

TEST_F(TextBlockTest, BreaksAParagraphIntoTheLinesThatItNeeds) {
  TextBlock text = block();
  const std::string word(6, 'm');
  const int words_in_line =
      static_cast<int>((block_area.width + width(" ", 20)) / (width(word, 20) + width(" ", 20)));
  std::string words = word;
  for (int i = 1; i < 3 * words_in_line; ++i) words += " " + word;
  text.add_paragraph(words, typeface_.regular, 20, {});
  EXPECT_EQ(text.extent().height, 3 * 27);
}

}  // namespace
}  // namespace twrench::picture
