#include "canvas/typesetting.h"

#include <gtest/gtest.h>

namespace twrench {
namespace {

class Typesetting : public testing::TestWithParam<const char*> {
 protected:
  const Typeface typeface = load_typeface(GetParam());
  const Font& font = typeface.regular;

  double width(std::string_view text) const { return typeset(font, text).width; }
};

TEST_P(Typesetting, GivesEachDigitTheSameRoom) {
  for (char digit = '0'; digit <= '9'; ++digit) {
    const std::string number{'1', digit, '.', digit, '7'};
    EXPECT_DOUBLE_EQ(width(number), width("18.87")) << number;
    const Line line = typeset(font, number);
    const double middle = line.glyphs[1].x + font.advance(line.glyphs[1].glyph) / 2;
    EXPECT_DOUBLE_EQ(middle, 1.5 * font.digit_advance()) << "in the middle of its room";
  }
}

TEST_P(Typesetting, MakesRaisedAndLoweredDigitsOfPlainOnes) {
  const Line line = typeset(font, "x₁²");
  ASSERT_EQ(line.glyphs.size(), 3U);
  EXPECT_EQ(line.glyphs[1].glyph, font.glyph(U'1'));
  EXPECT_EQ(line.glyphs[2].glyph, font.glyph(U'2'));
  EXPECT_GT(line.glyphs[1].y, 0);
  EXPECT_LT(line.glyphs[2].y, 0);
  EXPECT_LT(line.glyphs[1].scale, 1);
  EXPECT_DOUBLE_EQ(width("10⁻¹²"), width("10⁻⁸⁹"));
  EXPECT_LT(width("¹²"), width("12"));
}

TEST_P(Typesetting, MakesBlanksAsWideAsDigits) {
  EXPECT_DOUBLE_EQ(width("\u2007\u20071.5"), width("231.5"));
  EXPECT_DOUBLE_EQ(width("1\u2009000"), width("1000") + 0.2);
}

TEST_P(Typesetting, ShortensWithAnEllipsis) {
  const std::string title = "The Dzhanibekov effect";
  EXPECT_EQ(typeset_within(font, title, 100).glyphs.size(), title.size());
  for (int quarters = 48; quarters >= 0; --quarters) {
    const double room = 0.25 * quarters;
    const Line line = typeset_within(font, title, room);
    EXPECT_LE(line.width, room);
    if (room < 1.5) continue;
    ASSERT_FALSE(line.glyphs.empty()) << room;
    if (line.glyphs.size() < title.size()) {
      EXPECT_EQ(line.glyphs.back().glyph, font.glyph(U'…'));
      EXPECT_NE(line.glyphs[line.glyphs.size() - 2].glyph, font.glyph(U' ')) << room;
    }
  }
}

TEST_P(Typesetting, ShortensAVeryLongLineAtOnce) {
  std::string title;
  for (int i = 0; i < 20'000; ++i) title += "To be ";
  const Line line = typeset_within(font, title, 20);
  EXPECT_LE(line.width, 20);
  EXPECT_GT(line.width, 17.5) << "as much as fits";
}

TEST_P(Typesetting, KnowsWhatTheFontLacks) {
  EXPECT_EQ(missing_character(font, "ω₁ = 10⁻³ × 2\u2007\u2009é"), std::nullopt);
  EXPECT_EQ(missing_character(font, "a\uE123b"), U'\uE123');
}

INSTANTIATE_TEST_SUITE_P(Fonts, Typesetting, testing::Values("sans", "mono"));

TEST(Kerning, DrawsPairsTogether) {
  const Typeface typeface = load_typeface("sans");
  const Font& font = typeface.regular;
  const double apart = font.advance(font.glyph(U'T')) + font.advance(font.glyph(U'o'));
  EXPECT_LT(typeset(font, "To").width, apart - 0.02);
  EXPECT_DOUBLE_EQ(typeset(font, "To").glyphs[1].x,
                   typeset(font, "To").width - font.advance(font.glyph(U'o')));
}

}  // namespace
}  // namespace twrench
