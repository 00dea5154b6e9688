#include "system/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "scratch_folder.h"
#include "system/error.h"
#include "system/file.h"
#include "system/pending_file.h"

namespace {
bool vmsplice_is_there = true;
}

/// Replaces the C library's function.
extern "C" ssize_t vmsplice(int pipe, const iovec* pages, std::size_t count, unsigned flags) {
  if (vmsplice_is_there) return ::syscall(SYS_vmsplice, pipe, pages, count, flags);
  errno = ENOSYS;
  return -1;
}

namespace twrench::system {
namespace {

using std::chrono::milliseconds;
using ::testing::EndsWith;

std::vector<std::uint8_t> bytes(std::size_t count) {
  std::vector<std::uint8_t> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = static_cast<std::uint8_t>(i * 31 >> 4U);
  }
  return result;
}

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

TEST(ChildProcess, GetsEveryByte) {
  const ScratchFolder scratch;
  const auto sent = bytes(5'000'000);
  ChildProcess child({"dd", "bs=1M", "status=none", "of=" + (scratch / "out").string()});
  EXPECT_TRUE(child.write(sent));
  EXPECT_TRUE(child.write(sent));
  EXPECT_EQ(child.wait(), 0);
  auto twice = sent;
  twice.insert(twice.end(), sent.begin(), sent.end());
  EXPECT_EQ(read_file(scratch / "out", 20'000'000), twice);
}

/// With the real call or, as in a sandbox, without it.
class LentBytes : public testing::TestWithParam<bool> {
 protected:
  LentBytes() { vmsplice_is_there = GetParam(); }
  ~LentBytes() override { vmsplice_is_there = true; }
};

TEST_P(LentBytes, MayChangeWhenThePipeWasFilledAnew) {
  const ScratchFolder scratch;
  ChildProcess slow(shell("cd " + scratch.path().string() +
                          "; while dd bs=256k count=1 status=none of=part && [ -s part ]; "
                          "do cat part >>out; sleep 0.01; done"));
  std::array<std::vector<std::uint8_t>, 2> memory;
  std::vector<std::uint8_t> sent;
  for (std::size_t i = 0; i < 9; ++i) {
    auto& lent = memory[i % 2];
    lent.resize(slow.pipe_size() + 5000);
    for (std::size_t j = 0; j < lent.size(); ++j) {
      lent[j] = static_cast<std::uint8_t>((j * 31 >> 4U) + 41 * i);
    }
    EXPECT_TRUE(slow.lend(lent));
    sent.insert(sent.end(), lent.begin(), lent.end());
  }
  EXPECT_EQ(slow.wait(), 0);
  EXPECT_EQ(read_file(scratch / "out", 20'000'000), sent);
}

TEST_P(LentBytes, ADeadOneTakesNone) {
  ChildProcess child(shell("exit 0"));
  while (child.lend(bytes(1000))) {
  }
  EXPECT_EQ(child.wait(), 0);
}

INSTANTIATE_TEST_SUITE_P(If, LentBytes, testing::Bool(), [](const auto& param) {
  return std::string(param.param ? "lent" : "copied");
});

TEST(ChildProcess, TakesArgumentsAsTheyAre) {
  const std::string odd = "a 'b' \"c\" $(d) *;\n";
  ChildProcess child({"sh", "-c", "printf %s \"$1\" >&2", "sh", odd});
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.error_output(), odd);
}

TEST(ChildProcess, TellsItsExitStatusOrSignal) {
  EXPECT_EQ(ChildProcess(shell("exit 3")).wait(), 3);
  EXPECT_EQ(ChildProcess(shell("kill -TERM $$")).wait(), 128 + SIGTERM);
}

TEST(ChildProcess, WaitMayBeCalledAgain) {
  ChildProcess child(shell("exit 4"));
  EXPECT_EQ(child.wait(), 4);
  EXPECT_EQ(child.wait(), 4);
}

TEST(ChildProcess, ADeadOneTakesNothingAndDoesNotKillUs) {
  ChildProcess child(shell("echo gone >&2; exit 7"));
  EXPECT_FALSE(child.write(bytes(10'000'000)));
  EXPECT_EQ(child.wait(), 7);
  EXPECT_EQ(child.error_output(), "gone\n");
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

TEST(ChildProcess, OneThatDiesMidwayIsNoticed) {
  ChildProcess child(shell("head -c 3000000 >/dev/null; exit 9"));
  EXPECT_FALSE(child.write(bytes(10'000'000)));
  EXPECT_EQ(child.wait(), 9);
}

TEST(ChildProcess, SpeaksOnWhileItIsFed) {
  // Writes far more to standard error than a pipe holds before it reads its input.
  ChildProcess child(shell("yes complaint | head -c 1000000 >&2; echo last >&2; cat >/dev/null"));
  EXPECT_TRUE(child.write(bytes(5'000'000)));
  EXPECT_EQ(child.wait(), 0);
  EXPECT_EQ(child.error_output().size(), 8192U);
  EXPECT_THAT(child.error_output(), EndsWith("last\n"));
}

/// The number of descriptors that a child has.
std::string descriptors() {
  ChildProcess child(shell("ls /proc/self/fd | wc -l >&2"));
  EXPECT_EQ(child.wait(), 0);
  return child.error_output();
}

TEST(ChildProcess, InheritsNoDescriptorOfOurs) {
  const ScratchFolder scratch;
  const std::string before = descriptors();
  const PendingFile file(scratch / "file");
  const ChildProcess other({"cat"});
  EXPECT_EQ(descriptors(), before);
}

TEST(ChildProcess, HasTheSignalsAsAProgramExpectsThem) {
  const auto handler = std::signal(SIGPIPE, SIG_IGN);
  ChildProcess child(shell("kill -PIPE $$; exit 0"));
  EXPECT_EQ(child.wait(), 128 + SIGPIPE);
  (void)std::signal(SIGPIPE, handler);
}

TEST(ChildProcess, IsNotInTheTerminalsGroup) {
  // It has its own process group.
  ChildProcess child(shell("[ $(cut -d ' ' -f 5 /proc/$$/stat) = $$ ]"));
  EXPECT_EQ(child.wait(), 0);
}

/// Whether the process is running: neither gone, nor a zombie (Z) that init has yet to reap, nor
/// one that init is reaping (X).
bool runs(const std::string& pid) {
  try {
    const auto stat = read_file("/proc/" + pid + "/stat", 1000);
    const std::string text(stat.begin(), stat.end());
    return text.find(") Z") == std::string::npos && text.find(") X") == std::string::npos;
  } catch (const FileError&) {
    return false;
  }
}

/// Whether the condition becomes true within half a minute.
bool soon(const std::function<bool()>& condition) {
  for (int i = 0; i < 3000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(milliseconds(10));
  }
  return condition();
}

TEST(ChildProcess, IsKilledWithItsOwnerAndItsChildrenToo) {
  const ScratchFolder scratch;
  std::string sleeper;
  {
    const std::string pid = (scratch / "pid").string();
    const ChildProcess child(
        shell("sleep 1000 & echo $! >'" + pid + ".new'; mv '" + pid + ".new' '" + pid + "'; wait"));
    ASSERT_TRUE(soon([&] { return bool(std::ifstream(pid) >> sleeper); }));
    EXPECT_TRUE(runs(sleeper));
  }
  EXPECT_TRUE(soon([&] { return !runs(sleeper); }));
}

TEST(ChildProcess, ThatTakesNothingIsKilled) {
  const ScratchFolder scratch;
  const std::string begun = (scratch / "begun").string();
  ChildProcess child(shell("echo busy >&2; : >'" + begun + "'; sleep 1000"), {milliseconds(200)});
  ASSERT_TRUE(soon([&] { return std::filesystem::exists(begun); }));
  EXPECT_FALSE(child.write(bytes(10'000'000)));
  EXPECT_TRUE(child.timed_out());
  EXPECT_EQ(child.wait(), 128 + SIGKILL);
  EXPECT_EQ(child.error_output(), "busy\n");
}

TEST(ChildProcess, ThatDoesNotEndIsKilled) {
  for (const char* script : {"cat >/dev/null; sleep 1000", "exec 2>&-; cat; sleep 1000"}) {
    ChildProcess child(shell(script), {milliseconds(200)});
    EXPECT_TRUE(child.write(bytes(1000)));  // the pipe holds these if the child starts late
    EXPECT_EQ(child.wait(), 128 + SIGKILL);
    EXPECT_TRUE(child.timed_out());
  }
}

// Printing is no progress, however much is printed.
TEST(ChildProcess, ThatOnlyPrintsIsKilled) {
  const std::string prints = "while :; do echo busy; done >&2";
  for (const std::string& script : {prints, "cat >/dev/null; " + prints}) {
    ChildProcess child(shell(script), {milliseconds(500)});
    if (script == prints) {
      EXPECT_FALSE(child.write(bytes(10'000'000)));
    }
    EXPECT_EQ(child.wait(), 128 + SIGKILL);
    EXPECT_TRUE(child.timed_out());
    EXPECT_EQ(child.time_waited(), milliseconds(500));
  }
}

TEST(ChildProcess, IsNotWaitedForWhileItsOwnChildPrints) {
  const ScratchFolder scratch;
  const std::string pid = (scratch / "pid").string();
  ChildProcess child(shell("while :; do echo busy; done >&2 & echo $! >'" + pid + "'"));
  EXPECT_EQ(child.wait(), 0);
  EXPECT_THAT(child.error_output().size(), testing::Le(8192U));
  std::string printer;
  ASSERT_TRUE(std::ifstream(pid) >> printer);
  ::kill(std::stoi(printer), SIGKILL);
}

TEST(ChildProcess, IsKilledWhenAskedToStop) {
  std::atomic<bool> stop = false;
  const Patience patience{std::chrono::hours(1), &stop};
  ChildProcess writing(shell("sleep 1000"), patience);
  ChildProcess waiting(shell("cat >/dev/null; sleep 1000"), patience);
  const std::jthread other([&] {
    std::this_thread::sleep_for(milliseconds(50));
    stop = true;
  });
  EXPECT_FALSE(writing.write(bytes(10'000'000)));
  EXPECT_EQ(writing.wait(), 128 + SIGKILL);
  EXPECT_EQ(waiting.wait(), 128 + SIGKILL);
}

TEST(ChildProcess, MayTakeItsTimeWhileItTakesSomething) {
  // The pauses before the last megabyte that the pipe cannot hold are 3 s in total, which exceeds
  // the patience. Each is a fifth of it, because a busy machine prolongs them.
  ChildProcess child(
      shell("for i in 1 2 3 4 5 6 7 8; do head -c 1000000 >/dev/null; sleep 0.5; done"),
      {milliseconds(2500)});
  EXPECT_TRUE(child.write(bytes(8'000'000)));
  EXPECT_EQ(child.wait(milliseconds(10'000)), 0);
  EXPECT_FALSE(child.timed_out());
}

TEST(ChildProcess, ThatIsNotThereIsToldAtOnce) {
  try {
    const ChildProcess child({"no-such-program-of-ours"});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
  }
}

}  // namespace
}  // namespace twrench::system
