// The effort and the quality of videos, with the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/twrench.h"
#include "run_command.h"
#include "sanitizers.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Renders a few frames of a scene in a small size.
Outcome render(const ScratchFolder& folder, const std::string& rest,
               const std::string& frames = "0-4") {
  return run_twrench(
      folder, "render --size 160x90 --fps 25 --progress none --frames " + frames + " " + rest);
}

json manifest_in(const fs::path& folder) { return json::parse(text_of(folder / "manifest.json")); }

/// How well a video shows the frames in the folder: their structural similarity.
double similarity(const fs::path& video, const fs::path& frames) {
  const fs::path log = video.string() + ".ssim";
  run_command("ffmpeg -v error -i '" + video.string() + "' -framerate 25 -i '" +
              (frames / "frame_%06d.png").string() +
              "' -lavfi '[1:v]scale=out_color_matrix=bt709:flags=bicubic+accurate_rnd,"
              "format=yuv420p[drawn];[0:v][drawn]ssim=stats_file=" +
              log.string() + "' -f null -");
  // "n:1 Y:0.99 U:0.99 V:0.99 All:0.99 (20)", a line for each frame
  double sum = 0, count = 0;
  std::istringstream lines(text_of(log));
  for (std::string line; std::getline(lines, line); ++count) {
    sum += std::stod(line.substr(line.find("All:") + 4));
  }
  EXPECT_EQ(count, 25);
  return sum / count;
}

TEST(Quality, OfEachEffortIsThatOfTheDefault) {
  if (has_sanitizers) GTEST_SKIP() << "tests the encoder";
  for (const char* scene : {"dzhanibekov --theme space", "t-handle --theme paper", "phone"}) {
    const ScratchFolder folder;
    ASSERT_EQ(render(folder, std::string(scene) + " -o f.mp4", "0-24").code, 0);
    const double expected = similarity(folder / "f.mp4", folder / "f");
    for (const char* effort : {"fast", "balanced", "small"}) {
      const std::string video = std::string(effort) + ".mp4";
      const Outcome run = run_twrench(
          folder, std::string("encode f --progress none --encode ") + effort + " -o " + video);
      ASSERT_EQ(run.code, 0) << run.err;
      if (text_of(folder / video) == text_of(folder / "f.mp4")) continue;
      EXPECT_GE(similarity(folder / video, folder / "f"), expected - 0.002)
          << scene << " " << effort;
    }
    EXPECT_EQ(text_of(folder / "balanced.mp4"), text_of(folder / "f.mp4"));
    EXPECT_LT(fs::file_size(folder / "small.mp4"), fs::file_size(folder / "balanced.mp4"));
    EXPECT_GT(fs::file_size(folder / "fast.mp4"), fs::file_size(folder / "balanced.mp4"));
  }
}

TEST(Quality, IsWorseForALargerNumber) {
  if (has_sanitizers) GTEST_SKIP() << "tests the encoder";
  const ScratchFolder folder;
  for (const char* format : {"mp4", "mov", "mkv", "webm"}) {
    std::uintmax_t larger = std::numeric_limits<std::uintmax_t>::max();
    for (const char* crf : {"0", "50"}) {
      const std::string name = std::string("q") + crf + "." + format;
      const Outcome run =
          render(folder, std::string("wing-nut --no-frames --crf ") + crf + " -o " + name);
      ASSERT_EQ(run.code, 0) << run.err;
      EXPECT_LT(fs::file_size(folder / name), larger) << name;
      larger = fs::file_size(folder / name);
    }
  }
}

TEST(Quality, IsInTheManifest) {
  const ScratchFolder folder;
  ASSERT_EQ(render(folder, "book -o a.mp4").code, 0);
  EXPECT_EQ(manifest_in(folder / "a")["encode"], "balanced");
  EXPECT_EQ(manifest_in(folder / "a")["crf"], 16);
  ASSERT_EQ(render(folder, "book --encode small --crf 30 -o b.webm").code, 0);
  EXPECT_EQ(manifest_in(folder / "b")["encode"], "small");
  EXPECT_EQ(manifest_in(folder / "b")["crf"], 30);
  for (const char* without : {"--frames-dir c -o c.gif", "--frames-dir d --no-video"}) {
    const ScratchFolder other;
    ASSERT_EQ(render(other, std::string("book ") + without).code, 0);
    const json manifest = manifest_in(fs::exists(other / "c") ? other / "c" : other / "d");
    EXPECT_FALSE(manifest.contains("encode")) << without;
    EXPECT_FALSE(manifest.contains("crf")) << without;
  }
}

// The frames do not depend on the encoder, but the video does.
TEST(Quality, ChangesOnlyTheVideoOfAResumedRun) {
  const ScratchFolder folder;
  ASSERT_EQ(render(folder, "hammer -o f.mp4").code, 0);
  const auto frames = digests(folder / "f");
  const auto drawn = fs::last_write_time(folder / "f/frame_000003.png");
  const auto size = fs::file_size(folder / "f.mp4");
  const Outcome run = render(folder, "hammer -o f.mp4 --resume --crf 40");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(digests(folder / "f"), frames);
  EXPECT_EQ(fs::last_write_time(folder / "f/frame_000003.png"), drawn) << "it was drawn again";
  EXPECT_EQ(manifest_in(folder / "f")["crf"], 40);
  EXPECT_LT(fs::file_size(folder / "f.mp4"), size);
}

}  // namespace
}  // namespace twrench
