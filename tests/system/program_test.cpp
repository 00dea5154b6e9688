#include "system/program.h"

#include <gtest/gtest.h>

namespace twrench::system {
namespace {

TEST(LastWords, AreTheEndOfTheOutputOnOneLine) {
  EXPECT_EQ(last_words("first\nsecond\n\n"), "first; second");
  EXPECT_EQ(last_words(std::string(1000, 'x') + "end"), std::string(597, 'x') + "end");
  EXPECT_EQ(last_words("\n"), "it printed no message");
}

TEST(ShellCommand, QuotesWhatAShellWouldTakeApart) {
  const std::vector<std::string> command{"ffmpeg", "-vf", "a=b:c,d", "it's", "", "x y", "$z"};
  EXPECT_EQ(shell_command(command), "ffmpeg -vf a=b:c,d 'it'\\''s' '' 'x y' '$z'");
}

}  // namespace
}  // namespace twrench::system
