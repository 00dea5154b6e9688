#include "base/letters.h"

#include <gtest/gtest.h>

namespace twrench {
namespace {

TEST(InSmallLetters, ChangesTheLettersOfEnglishAlone) {
  EXPECT_EQ(to_lower("A.PNG z[@`{ 09"), "a.png z[@`{ 09");
  EXPECT_EQ(to_lower("\xc3\x84\xd6\xff"), "\xc3\x84\xd6\xff");
  EXPECT_EQ(to_lower(""), "");
}

}  // namespace
}  // namespace twrench
