#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <string>

#include "scratch_folder.h"
#include "system/child_process.h"

namespace twrench::system {
namespace {

/// The output of a shell script.
std::string output_of_script(const std::string& script) {
  std::string text;
  OutputPipe pipe(
      [&](std::span<const std::uint8_t> bytes) { text.append(bytes.begin(), bytes.end()); });
  ChildProcess child({"sh", "-c", script}, {}, pipe.descriptor());
  EXPECT_EQ(child.wait(), 0);
  pipe.finish();
  return text;
}

TEST(OutputPipe, ReceivesAllBytes) {
  EXPECT_EQ(output_of_script("printf 'one '; sleep 0.3; printf two"), "one two");
  // More than a pipe holds.
  EXPECT_EQ(output_of_script("head -c 3000000 /dev/zero | tr '\\0' x"),
            std::string(3'000'000, 'x'));
  EXPECT_EQ(output_of_script(":"), "");
}

TEST(OutputPipe, EndsWithTheChildAlthoughItsOwnChildKeepsItOpen) {
  const ScratchFolder scratch;
  const std::string pid = (scratch / "pid").string();
  EXPECT_EQ(output_of_script("sleep 1000 & echo $! >'" + pid + "'; printf done"), "done");
  int sleeper = 0;
  ASSERT_TRUE(std::ifstream(pid) >> sleeper);
  ::kill(sleeper, SIGKILL);
}

TEST(OutputPipe, WithoutAChildIsClosed) {
  const OutputPipe pipe([](std::span<const std::uint8_t>) { FAIL(); });
}

}  // namespace
}  // namespace twrench::system
