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

TEST(Names, AreListedUpToThree) {
  const std::vector<std::string> names{"a", "b", "c", "d", "e"};
  const auto list = [&](std::size_t count) { return list_of_names(std::span(names).first(count)); };
  EXPECT_EQ(list(1), "'a'");
  EXPECT_EQ(list(2), "'a' and 'b'");
  EXPECT_EQ(list(3), "'a', 'b' and 'c'");
  EXPECT_EQ(list(4), "'a', 'b', 'c' and 1 other");
  EXPECT_EQ(list(5), "'a', 'b', 'c' and 2 others");
}

}  // namespace
}  // namespace twrench
