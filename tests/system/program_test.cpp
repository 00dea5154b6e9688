#include "system/program.h"

#include <gtest/gtest.h>

#include <chrono>

namespace twrench::system {
namespace {

TEST(LastWords, AreTheEndOfTheOutputOnOneLine) {
  EXPECT_EQ(error_summary("first\nsecond\n\n"), "first; second");
  EXPECT_EQ(error_summary(std::string(1000, 'x') + "end"), std::string(597, 'x') + "end");
  EXPECT_EQ(error_summary("\n"), "it printed no message");
}

TEST(FailureOf, NamesTheStatusOrTheTimeOrTheInputThatWasNotRead) {
  const auto failure = [](const std::string& script) {
    ChildProcess child({"sh", "-c", script}, {std::chrono::milliseconds(300)});
    const int status = child.wait();
    return failure_of("sh", child, status);
  };
  EXPECT_EQ(failure("echo no >&2; exit 3"), "sh ended with exit status 3: no");
  EXPECT_EQ(failure("exec sleep 1000"),
            "sh made no progress for 0.3 s and was killed: it printed no message");
  EXPECT_EQ(failure("exit 0"),
            "sh ended before it had read all of its input: it printed no message");
}

TEST(ShellCommand, QuotesWhatAShellWouldTakeApart) {
  const std::vector<std::string> command{"ffmpeg", "-vf", "a=b:c,d", "it's", "", "x y", "$z"};
  EXPECT_EQ(shell_command(command), "ffmpeg -vf a=b:c,d 'it'\\''s' '' 'x y' '$z'");
}

}  // namespace
}  // namespace twrench::system
