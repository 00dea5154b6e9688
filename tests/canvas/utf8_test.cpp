#include "canvas/utf8.h"

#include <gmock/gmock.h>

namespace twrench {
namespace {

using testing::ElementsAre;

TEST(DecodeUtf8, ReadsOneToFourBytes) {
  EXPECT_THAT(decode_utf8("aω…😀"), ElementsAre(U'a', U'ω', U'…', U'😀'));
  EXPECT_THAT(decode_utf8(""), ElementsAre());
}

TEST(DecodeUtf8, PutsAReplacementForEachByteThatIsIllFormed) {
  const char32_t bad = U'\uFFFD';
  EXPECT_THAT(decode_utf8("a\xFFz"), ElementsAre(U'a', bad, U'z'));
  EXPECT_THAT(decode_utf8("\x80"), ElementsAre(bad)) << "a continuation without a lead";
  EXPECT_THAT(decode_utf8("\xCF"), ElementsAre(bad)) << "a lead at the end";
  EXPECT_THAT(decode_utf8("\xE2\x88z"), ElementsAre(bad, bad, U'z'));
  EXPECT_THAT(decode_utf8("\xC0\xAF"), ElementsAre(bad, bad)) << "overlong";
  EXPECT_THAT(decode_utf8("\xE0\x80\xAF"), ElementsAre(bad, bad, bad)) << "overlong";
  EXPECT_THAT(decode_utf8("\xED\xA0\x80"), ElementsAre(bad, bad, bad)) << "a surrogate";
  EXPECT_THAT(decode_utf8("\xF4\x90\x80\x80"), ElementsAre(bad, bad, bad, bad)) << "past the last";
}

TEST(DecodeUtf8, TakesControlCharactersForSpaces) {
  EXPECT_THAT(decode_utf8("a\n\x7F\xC2\x85z"), ElementsAre(U'a', U' ', U' ', U' ', U'z'));
}

}  // namespace
}  // namespace twrench
