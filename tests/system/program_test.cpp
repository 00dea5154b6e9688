#include "system/program.h"

#include <gtest/gtest.h>

namespace twrench::system {
namespace {

TEST(LastWords, AreTheEndOfTheOutputOnOneLine) {
  EXPECT_EQ(error_summary("first\nsecond\n\n"), "first; second");
  EXPECT_EQ(error_summary(std::string(1000, 'x') + "end"), std::string(597, 'x') + "end");
  EXPECT_EQ(error_summary("\n"), "it printed no message");
}

TEST(ShellCommand, QuotesWhatAShellWouldTakeApart) {
  const std::vector<std::string> command{"ffmpeg", "-vf", "a=b:c,d", "it's", "", "x y", "$z"};
  EXPECT_EQ(shell_command(command), "ffmpeg -vf a=b:c,d 'it'\\''s' '' 'x y' '$z'");
}

}  // namespace
}  // namespace twrench::system
