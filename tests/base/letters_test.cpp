#include <gmock/gmock.h>

#include "base/words.h"

namespace twrench {
namespace {

TEST(InSmallLetters, ChangesTheLettersOfEnglishAlone) {
  EXPECT_EQ(to_lower("A.PNG z[@`{ 09"), "a.png z[@`{ 09");
  EXPECT_EQ(to_lower("\xc3\x84\xd6\xff"), "\xc3\x84\xd6\xff");
  EXPECT_EQ(to_lower(""), "");
}

TEST(WordsOf, AreSeparatedByWhiteSpace) {
  EXPECT_THAT(words_of("  a bc\n\td "), testing::ElementsAre("a", "bc", "d"));
  EXPECT_THAT(words_of(" "), testing::IsEmpty());
}

}  // namespace
}  // namespace twrench
