#include <gtest/gtest.h>

#include "canvas/font_bytes.h"
#include "canvas/text_runs.h"

namespace twrench::canvas {
namespace {

/// For each character of the text, `f` if it is set in a font with the characters `own`, and `s` if
/// it is set in the fallback, the sans.
std::string fonts(std::u32string_view own, std::string_view utf8) {
  const Typeface sans = load_typeface("sans");
  const Font font = Font(many_scripts_file(own), "F").with_fallback(sans.regular);
  std::string fonts;
  for (const Font* chosen : choose_fonts(styled(utf8).characters, font)) {
    fonts += chosen == &font ? 'f' : chosen == font.fallback() ? 's' : '?';
  }
  return fonts;
}

TEST(ChooseFonts, StandsInForWhatTheFontLacks) {
  EXPECT_EQ(fonts(U"abc", "abcd"), "fffs");
  EXPECT_EQ(fonts(U"س", "aسb"), "sfs");
  EXPECT_EQ(fonts(U"س", "क"), "f") << "neither has it";
  EXPECT_EQ(fonts(U"س", ""), "");
}

TEST(ChooseFonts, HasSpacesAndSignsOfTheFontBesideThem) {
  EXPECT_EQ(fonts(U"سل ,-", "ab, cd - سل, سل"), "sssssssssffffff");
  EXPECT_EQ(fonts(U"سل ", "سل, ab"), "ffsfss") << "the one that has it";
  EXPECT_EQ(fonts(U"س ,", ", ab س"), "sssssf") << "before the first letter";
  EXPECT_EQ(fonts(U"س-", "- -"), "fsf") << "no letters";
}

TEST(ChooseFonts, HasBothBracketsOfOneFont) {
  EXPECT_EQ(fonts(U"سل ()«»", "سل (ab) «سل»"), "fffsssssffff");
  EXPECT_EQ(fonts(U"سل ()", "ab (سل) ab"), "sssfffffss");
  EXPECT_EQ(fonts(U"س()1234567890", "(a 1) (س a)"), "sssfssffssf");
}

TEST(ChooseFonts, DoesNotPartALetterFromItsMarks) {
  EXPECT_EQ(fonts(U"xy", "x\u0301y"), "ssf") << "the sans has both";
  EXPECT_EQ(fonts(U"x\u0301", "x\u0301"), "ff");
  EXPECT_EQ(fonts(U"eé", "e\u0301"), "ff") << "composed";
  EXPECT_EQ(fonts(U"e\u0301", "é"), "f") << "decomposed";
  EXPECT_EQ(fonts(U"سل", "سل\u0301س"), "ffsf") << "but none has both";
  EXPECT_EQ(fonts(U"سل", "س\u200Dل\u20D7"), "ffff") << "a joiner, and what neither has";
}

TEST(ChooseFonts, HasAllDigitsOfOneFont) {
  EXPECT_EQ(fonts(U"a012345678", "a10.8"), "fssss");
  EXPECT_EQ(fonts(U"0123456789.", "10.8ab 1²"), "ffffsssff");
}

}  // namespace
}  // namespace twrench::canvas
