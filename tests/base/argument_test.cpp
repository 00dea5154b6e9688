#include <gtest/gtest.h>

#include "base/words.h"

namespace twrench {
namespace {

std::string as_option(std::string_view name, std::string_view value) {
  return std::string("--").append(name).append(value.empty() ? "" : " ").append(value);
}

TEST(Arguments, AreWordedWhereATextMentionsThem) {
  const std::string text =
      "use " + argument("units", "deg") + " or " + argument("fit") + ", not both";
  EXPECT_EQ(with_arguments(text, as_option), "use --units deg or --fit, not both");
  EXPECT_EQ(with_arguments(argument("axes", "x,-z,y"), as_option), "--axes x,-z,y");
}

TEST(Arguments, LeaveOtherTextsAsTheyAre) {
  for (const char* const text :
       {"", "no mention", "a\x1f", "\x02", "\x03\x02", "\x02name\x1f", "\x02\x03\x1f"}) {
    EXPECT_EQ(with_arguments(text, as_option), text);
  }
}

}  // namespace
}  // namespace twrench
