#include "canvas/typesetting.h"

#include <gtest/gtest.h>
#include <hb.h>

#include <algorithm>

#include "canvas/font_bytes.h"

namespace twrench::canvas {
namespace {

/// The left and the right end of the glyph, in em from the pen.
std::pair<double, double> ink_of(const Font& font, unsigned glyph) {
  hb_glyph_extents_t extents{};
  hb_font_get_glyph_extents(font.shaper(), glyph, &extents);
  const double left = 1.0 * extents.x_bearing / font.units_per_em();
  return {left, left + 1.0 * extents.width / font.units_per_em()};
}

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
    EXPECT_EQ(line.glyphs.size(), number.size());
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
  EXPECT_NEAR(width("1\u2009000"), width("1000") + 0.2, 1e-12);
}

TEST_P(Typesetting, ShortensWithAnEllipsis) {
  const std::string title = "The Dzhanibekov effect";
  const Line whole = typeset(font, title);
  EXPECT_EQ(typeset_within(font, title, 100).glyphs.size(), whole.glyphs.size());
  for (int quarters = 48; quarters >= 0; --quarters) {
    const double room = 0.25 * quarters;
    const Line line = typeset_within(font, title, room);
    EXPECT_LE(line.width, room);
    if (room < 1.5) continue;
    ASSERT_FALSE(line.glyphs.empty()) << room;
    if (line.width < whole.width) {
      EXPECT_EQ(line.glyphs.back().glyph, font.glyph(U'…'));
      EXPECT_NE(line.glyphs[line.glyphs.size() - 2].glyph, font.glyph(U' ')) << room;
    }
  }
}

TEST_P(Typesetting, ShortensToNothingWhereNothingHasRoom) {
  for (const double room : {0.1, 0.0, -1.0}) {
    EXPECT_TRUE(typeset_within(font, "title", room).glyphs.empty()) << room;
    EXPECT_TRUE(typeset_within(font, "", room).glyphs.empty()) << room;
  }
}

TEST_P(Typesetting, DoesNotPartALetterFromItsMarks) {
  const std::string text = "x\u0301x\u0301x\u0301x\u0301";
  for (double room = width(text); room > 1; room -= 0.05) {
    const Line line = typeset_within(font, text, room);
    const auto letters = std::ranges::count(line.glyphs, font.glyph(U'x'), &Line::Placed::glyph);
    const auto marks = std::ranges::count(line.glyphs, font.glyph(U'\u0301'), &Line::Placed::glyph);
    EXPECT_EQ(letters, marks) << room;
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
  EXPECT_EQ(missing_character(font, "ω₁ = 10⁻³ × 2\u2007\u2009é e\u0301"), std::nullopt);
  EXPECT_EQ(missing_character(font, "a\u200D\u200Bb\u00AD"), std::nullopt) << "nothing to see";
  EXPECT_EQ(missing_character(font, "a\uE123b\uE124"), U'\uE123') << "the first";
  EXPECT_EQ(missing_character(font, "\u05D0\uE123 \u05D1\uE124"), U'\u05D0')
      << "the first in the text, not on the line";
  EXPECT_EQ(missing_character(font, "e\u0301\u20D7"), U'\u20D7') << "the mark, not its letter";
}

TEST_P(Typesetting, ComposesALetterWithItsMark) {
  const Line line = typeset(font, "e\u0301");
  ASSERT_EQ(line.glyphs.size(), 1U);
  EXPECT_EQ(line.glyphs[0].glyph, font.glyph(U'é'));
}

TEST_P(Typesetting, SetsAMarkOverItsLetter) {
  for (const char* text : {"x\u0301", "q\u0301"}) {
    const Line line = typeset(font, text);
    ASSERT_EQ(line.glyphs.size(), 2U);
    const Line::Placed& mark = line.glyphs[1];
    EXPECT_EQ(mark.glyph, font.glyph(U'\u0301'));
    EXPECT_EQ(line.width, font.advance(line.glyphs[0].glyph)) << "takes no room";
    const auto [left, right] = ink_of(font, mark.glyph);
    EXPECT_NEAR(mark.x + (left + right) / 2, line.width / 2, 0.12) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Fonts, Typesetting, testing::Values("sans", "mono"));

// The digits of the built-in fonts have equal widths already.
TEST(Digits, TakeTheWidestOnesRoomWhereTheirOwnDiffers) {
  std::vector<std::uint8_t> file = sans_file();
  const unsigned one = Font(file, "F").glyph(U'1');
  table(file, "hmtx")[4 * one] /= 2;  // the high byte of its advance
  const Font font(std::move(file), "F");
  ASSERT_LT(font.advance(one), 0.6 * font.digit_advance());
  const Line line = typeset(font, "171");
  EXPECT_NEAR(line.width, 3 * font.digit_advance(), 1e-12);
  EXPECT_NEAR(line.glyphs[0].x, (font.digit_advance() - font.advance(one)) / 2, 1e-12);
  EXPECT_NEAR(typeset(font, "T1.1").width, typeset(font, "T7.7").width, 1e-12) << "not kerned";
}

TEST(Kerning, DrawsPairsTogether) {
  const Typeface typeface = load_typeface("sans");
  const Font& font = typeface.regular;
  const double apart = font.advance(font.glyph(U'T')) + font.advance(font.glyph(U'o'));
  const Line line = typeset(font, "To");
  EXPECT_LT(line.width, apart - 0.02);
  EXPECT_NEAR(line.glyphs[1].x, line.width - font.advance(font.glyph(U'o')), 1e-12);
  EXPECT_NEAR(typeset(font, "HH").width, 2 * font.advance(font.glyph(U'H')), 1e-12);
}

/// With a font that has all these scripts.
class Scripts : public testing::Test {
 protected:
  const Font font{many_scripts_file(), "F"};

  /// The glyphs from left to right.
  std::vector<unsigned> glyphs(std::string_view text) const {
    std::vector<unsigned> glyphs;
    for (const Line::Placed& placed : typeset(font, text).glyphs) glyphs.push_back(placed.glyph);
    return glyphs;
  }
};

TEST_F(Scripts, ArabicLettersJoinFromRightToLeft) {
  EXPECT_EQ(missing_character(font, "تأثير جانيبيكوف"), std::nullopt);
  const std::vector<unsigned> joined = glyphs("ببب"), alone = glyphs("ب");
  ASSERT_EQ(joined.size(), 3U);
  EXPECT_EQ(alone[0], font.glyph(U'ب'));
  for (const unsigned glyph : joined) EXPECT_NE(glyph, alone[0]) << "a form that joins";
  EXPECT_NE(joined[0], joined[2]) << "the last letter is not the first";
  const Line line = typeset(font, "بد");
  EXPECT_GT(line.glyphs[0].character, line.glyphs[1].character)
      << "the first letter is on the right";
}

TEST_F(Scripts, DevanagariVowelsGoWhereTheyAreWritten) {
  EXPECT_EQ(missing_character(font, "जानिबेकोव प्रभाव"), std::nullopt);
  const std::vector<unsigned> syllable = glyphs("कि");
  ASSERT_EQ(syllable.size(), 2U);
  EXPECT_EQ(syllable[1], font.glyph(U'क')) << "the short i stands before its consonant";
  EXPECT_EQ(glyphs("क्ष").size(), 1U) << "a conjunct";
}

TEST_F(Scripts, ALineOfBothDirectionsKeepsTheWordsOfEach) {
  const Line line = typeset(font, "ab \u05D0\u05D1 12");
  std::vector<std::size_t> order;
  for (const Line::Placed& placed : line.glyphs) order.push_back(placed.character);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 6, 7, 5, 4, 3})) << "as UAX #9 has it";
}

TEST_F(Scripts, AShortenedLineFromRightToLeftEndsOnTheLeft) {
  const Line line = typeset_within(font, "תנועה סיבובית", 4);
  ASSERT_GT(line.glyphs.size(), 3U);
  EXPECT_EQ(line.glyphs.front().glyph, font.glyph(U'…'));
}

/// A font of some characters, with the sans as its fallback.
class Fallback : public testing::Test {
 protected:
  const Typeface typeface = load_typeface("sans");
  const Font& sans = typeface.regular;

  Font font(std::u32string_view characters) const {
    return Font(many_scripts_file(characters), "F").with_fallback(sans);
  }
};

TEST_F(Fallback, SetsEachCharacterAsTheFontThatHasIt) {
  const Font arabic = font(U"سلام ");
  const Line line = typeset(arabic, "Hi س");
  ASSERT_EQ(line.glyphs.size(), 4U);
  EXPECT_EQ(line.glyphs[0].font, arabic.fallback());
  EXPECT_EQ(line.glyphs[0].glyph, sans.glyph(U'H'));
  EXPECT_EQ(line.glyphs[3].font, &arabic);
  EXPECT_EQ(line.glyphs[3].glyph, arabic.glyph(U'س'));
  EXPECT_NEAR(line.glyphs[3].x, typeset(sans, "Hi ").width, 1e-12) << "in em of its own font";
  EXPECT_NEAR(line.width, line.glyphs[3].x + arabic.advance(arabic.glyph(U'س')), 1e-12);
  EXPECT_EQ(typeset(arabic, "س").width, arabic.advance(arabic.glyph(U'س')));
}

TEST_F(Fallback, LeavesOnlyWhatNeitherFontHas) {
  const Font arabic = font(U"سلام");
  EXPECT_EQ(missing_character(arabic, "Flip: سلام × 10⁻³ e\u0301…"), std::nullopt);
  EXPECT_EQ(missing_character(arabic, "Flip سلام क"), U'क');
  EXPECT_EQ(missing_character(arabic, "س\u20D7"), U'\u20D7') << "a mark";
  EXPECT_EQ(missing_character(sans, "Flip سلام"), U'س') << "nothing stands in for the sans";
}

TEST_F(Fallback, KeepsTheRoomOfDigits) {
  for (const std::u32string_view own : {U"0123456789", U"012345678"}) {
    const Font some = font(own);
    const Font& digits = own.size() == 10 ? some : sans;
    const double room = 4 * typeset(digits, "1").width;
    for (const char* number : {"1989", "7123", "\u2007\u200711"}) {
      EXPECT_NEAR(typeset(some, number).width, room, 1e-12) << number << ", " << own.size();
    }
  }
  EXPECT_NE(typeset(font(U"0123456789"), "1").width, typeset(sans, "1").width);
}

}  // namespace
}  // namespace twrench::canvas
