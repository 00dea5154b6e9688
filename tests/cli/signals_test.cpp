// A signal ends every command at once, whatever it is waiting for, and leaves no partial files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "cli/twrench.h"

namespace twrench {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Succeeds shortly after the program has blocked SIGTERM, which it does before it waits for
/// signals. An earlier signal ends the process without a message.
const std::string heeds_signals =
    "{ grep -q '^SigBlk:.*[4567cdef]...$' /proc/$pid/status && sleep 0.3; }";

/// Runs the command with all signals enabled, sends it the signal once `ready` succeeds, and waits.
/// `before` sets its environment.
Outcome run_and_signal(const ScratchFolder& folder, const std::string& command,
                       const std::string& signal, const std::string& ready,
                       const std::string& before = "") {
  return run_shell(folder, before + "env --default-signal=INT,TERM,HUP \"$TWRENCH\" " + command +
                               " & pid=$!; until " + ready + "; do sleep 0.05; done; kill -" +
                               signal + " $pid; wait $pid");
}

/// Checks that the signal ended the command and that only `left` remains.
void expect_ended(const ScratchFolder& folder, const Outcome& run, int code,
                  const std::vector<std::string>& left) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_THAT(run.err, HasSubstr("interrupted by SIG"));
  std::vector<std::string> names = folder.names();
  std::erase(names, "stdout.txt");
  std::erase(names, "stderr.txt");
  EXPECT_THAT(names, testing::UnorderedElementsAreArray(left));
}

// This integration would take a minute.
TEST(Signals, EndAnIntegration) {
  const std::pair<const char*, int> signals[] = {
      {"INT", 130}, {"TERM", 143}, {"HUP", 143}, {"XCPU", 143}};
  for (const auto& [signal, code] : signals) {
    const ScratchFolder folder;
    const auto start = std::chrono::steady_clock::now();
    const Outcome run = run_and_signal(folder, "simulate --step 2e-6 --method suzuki4 -o x.csv",
                                       signal, heeds_signals);
    expect_ended(folder, run, code, {});
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  }
}

TEST(Signals, EndAWaitForAPipe) {
  const ScratchFolder folder;
  ASSERT_EQ(run_shell(folder, "mkfifo pipe").code, 0);
  expect_ended(folder, run_and_signal(folder, "compare pipe pipe", "INT", heeds_signals), 130,
               {"pipe"});
  expect_ended(folder, run_and_signal(folder, "simulate -o pipe", "TERM", heeds_signals), 143,
               {"pipe"});
}

// An ffmpeg that passes the test, which has no output file, and then accepts no data.
const std::string hang =
    "mkdir bin && printf '#!/bin/sh\\ncase \"$*\" in *null*) cat >/dev/null; exit;; esac\\n"
    "echo $$ >../hung; exec sleep 1000\\n' >bin/ffmpeg && chmod +x bin/ffmpeg";

TEST(Signals, EndAWaitForFfmpegAndEndItToo) {
  const ScratchFolder folder;
  ASSERT_EQ(run_shell(folder, hang + " && mkdir d").code, 0);
  const std::string film = "render --size 640x360 --progress none --no-frames -o v.mp4";
  const Outcome run =
      run_and_signal(folder, film, "HUP", "[ -s ../hung ]", "cd d; PATH=\"$PWD/../bin:$PATH\" ");
  expect_ended(folder, run, 143, {"bin", "d", "hung"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / "d"));
  // Until its new parent has reaped it, the ffmpeg has an entry as a zombie (Z, then X).
  const Outcome gone = run_shell(folder,
                                 "for i in $(seq 3000); do grep -qs '^State:[[:space:]]*[^ZX]' "
                                 "/proc/$(cat hung)/status || exit 0; "
                                 "sleep 0.01; done; exit 1");
  EXPECT_EQ(gone.code, 0) << "ffmpeg goes on";
}

TEST(Signals, EndAnEncodingWithoutATemporary) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder,
                        "render --size 64x36 --frames 0-9 --no-video --progress none "
                        "--frames-dir f")
                .code,
            0);
  ASSERT_EQ(run_shell(folder, hang + " && mkdir d").code, 0);
  const Outcome run = run_and_signal(folder, "encode ../f -o v.mp4 --progress none", "INT",
                                     "[ -s ../hung ]", "cd d; PATH=\"$PWD/../bin:$PATH\" ");
  expect_ended(folder, run, 130, {"bin", "d", "f", "hung"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / "d"));
}

TEST(Signals, TellHowManyFramesTheRunHasDrawn) {
  const ScratchFolder folder;
  // Thousands of frames, so that the signal comes before the last one even on a busy machine.
  const std::string film =
      "render --size 160x90 --fps 10 --speed 6 --duration 3000 --no-video --progress none "
      "--frames-dir f --frames ";
  ASSERT_EQ(run_twrench(folder, film + "0-9").code, 0);
  const Outcome run = run_and_signal(folder, film + "100-4999", "INT", "[ -e f/frame_000104.png ]");
  EXPECT_EQ(run.code, 130);
  const std::size_t drawn = digests(folder / "f").size() - 10;
  EXPECT_THAT(run.err, HasSubstr("after " + std::to_string(drawn) + " of 4900 frames"));
}

TEST(Signals, ThatTheParentIgnoresStayIgnored) {
  const ScratchFolder folder;
  const Outcome run = run_shell(
      folder,
      "trap '' INT HUP; \"$TWRENCH\" render --size 160x90 --frames 0-99 --no-video "
      "--progress none --frames-dir f & pid=$!; until [ -e f/frame_000001.png ]; do sleep 0.01; "
      "done; kill -INT $pid; kill -HUP $pid; wait $pid");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, Not(HasSubstr("interrupted")));
}

TEST(Signals, AFileThatMayNotGrowIsAnErrorOfFiles) {
  const ScratchFolder folder;
  const Outcome data = run_shell(folder, "ulimit -f 1; \"$TWRENCH\" simulate -o x.csv");
  EXPECT_EQ(data.code, 5) << data.err;
  EXPECT_THAT(data.err, HasSubstr("File too large"));
  const Outcome film = run_shell(
      folder,
      "ulimit -f 20; \"$TWRENCH\" render --size 160x90 --frames 0-99 --crf 0 --progress none "
      "--no-frames -o v.mp4");
  EXPECT_EQ(film.code, 5) << film.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "v.mp4"));
}

}  // namespace
}  // namespace twrench
