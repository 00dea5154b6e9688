#include "canvas/text_runs.h"

#include <gmock/gmock.h>

namespace twrench::canvas {
namespace {

using testing::ElementsAre;

std::vector<char32_t> characters(std::string_view utf8) {
  const StyledText text = styled(utf8);
  return {text.characters.begin(), text.characters.end()};
}

TEST(StyledText, ReadsOneToFourBytes) {
  EXPECT_THAT(characters("aω…😀"), ElementsAre(U'a', U'ω', U'…', U'😀'));
  EXPECT_THAT(characters(""), ElementsAre());
}

TEST(StyledText, HasAReplacementForEachByteThatIsIllFormed) {
  const char32_t bad = U'\uFFFD';
  EXPECT_THAT(characters("a\xFFz"), ElementsAre(U'a', bad, U'z'));
  EXPECT_THAT(characters("\x80"), ElementsAre(bad)) << "a continuation without a lead";
  EXPECT_THAT(characters("\xCF"), ElementsAre(bad)) << "a lead at the end";
  EXPECT_THAT(characters("\xE2\x88z"), ElementsAre(bad, bad, U'z'));
  EXPECT_THAT(characters("\xC0\xAF"), ElementsAre(bad, bad)) << "overlong";
  EXPECT_THAT(characters("\xE0\x80\xAF"), ElementsAre(bad, bad, bad)) << "overlong";
  EXPECT_THAT(characters("\xED\xA0\x80"), ElementsAre(bad, bad, bad)) << "a surrogate";
  EXPECT_THAT(characters("\xF4\x90\x80\x80"), ElementsAre(bad, bad, bad, bad)) << "past the last";
}

TEST(StyledText, HasSpacesForControlCharacters) {
  EXPECT_THAT(characters(std::string_view("a\n\x7F\xC2\x85\0z", 7)),
              ElementsAre(U'a', U' ', U' ', U' ', U' ', U'z'));
}

TEST(StyledText, TellsRaisedAndLoweredOnesFromPlain) {
  const StyledText text = styled("x₁1⁻²");
  EXPECT_THAT(characters("x₁1⁻²"), ElementsAre(U'x', U'1', U'1', U'−', U'2'));
  EXPECT_THAT(text.styles,
              ElementsAre(CharacterStyle::plain, CharacterStyle::lowered, CharacterStyle::figure,
                          CharacterStyle::raised, CharacterStyle::raised));
}

TEST(StyledText, SetsAMarkAsItsLetter) {
  EXPECT_THAT(styled("1\u0301").styles,
              ElementsAre(CharacterStyle::figure, CharacterStyle::figure));
}

TEST(StyledText, IsShortenedByAnEllipsis) {
  const StyledText text = shortened(styled("ab²"), 1);
  EXPECT_EQ(text.characters, styled("a…").characters);
  EXPECT_EQ(text.styles, styled("a…").styles);
}

/// The text in the order of its runs, with runs from right to left in brackets. A, B and C
/// represent the Hebrew letters alef, bet and gimel.
std::string shown(std::u32string_view text) {
  const StyledText all{{text.begin(), text.end()},
                       std::vector<CharacterStyle>(text.size(), CharacterStyle::plain)};
  const Typeface sans = load_typeface("sans");
  std::string line;
  for (const TextRun& run : visual_runs(all, sans.regular)) {
    std::string letters;
    for (const char32_t c : text.substr(run.begin, run.end - run.begin)) {
      letters += static_cast<char>(c < 0x80 ? c : c - 0x5D0 + 'A');
    }
    line += run.direction == HB_DIRECTION_RTL ? '[' + letters + ']' : letters;
  }
  return line;
}

TEST(VisualRuns, FollowTheBidirectionalAlgorithm) {
  EXPECT_EQ(shown(U"ab \u05D0\u05D1 cd"), "ab [AB] cd");
  EXPECT_EQ(shown(U"\u05D0\u05D1 ab \u05D2"), "[C][ ]ab[AB ]") << "the line is from right to left";
  EXPECT_EQ(shown(U"\u05D0 12 \u05D1"), "[ B]12[A ]") << "numbers are not";
  EXPECT_EQ(shown(U"\u05D0 (\u05D1)"), "[A (B)]") << "brackets go with their words";
  EXPECT_EQ(shown(U"ab 12"), "ab 12");
  EXPECT_EQ(shown(U"..."), "...");
  EXPECT_EQ(shown(U""), "");
}

TEST(VisualRuns, AreOfOneScriptAndStyle) {
  const Typeface sans = load_typeface("sans");
  std::vector<hb_script_t> scripts;
  for (const TextRun& run : visual_runs(styled("«Эффект» e\u0301, क"), sans.regular)) {
    scripts.push_back(run.script);
  }
  EXPECT_THAT(scripts, ElementsAre(HB_SCRIPT_CYRILLIC, HB_SCRIPT_LATIN, HB_SCRIPT_DEVANAGARI))
      << "signs go with the letters beside them";
  EXPECT_EQ(visual_runs(styled("a10b²"), sans.regular).size(), 4U);
}

}  // namespace
}  // namespace twrench::canvas
