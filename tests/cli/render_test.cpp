// End-to-end tests of small renders with the real program, ffmpeg and ffprobe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "cli/twrench.h"
#include "image/compare.h"
#include "image/png.h"
#include "run_command.h"
#include "system/bytes.h"
#include "system/file.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// 1.2 s of video, 12 frames.
const std::string small_film =
    "render --size 160x90 --fps 10 --duration 7.2 --speed 6 --progress none ";

json probe(const ScratchFolder& folder, const std::string& video) {
  run_command("ffprobe -v error -count_frames -show_streams -of json '" +
              (folder / video).string() + "' >'" + (folder / "probe.json").string() + "'");
  return json::parse(text_of(folder / "probe.json"))["streams"][0];
}

TEST(Render, AFractionalRateIsExact) {
  const ScratchFolder folder;
  const std::string film = "render --size 32x32 --bare --duration 1 --speed 1 --progress none ";
  for (const std::string video : {"a.mp4", "a.mov", "a.mkv", "a.webm"}) {
    const Outcome run =
        run_twrench(folder, film + "--fps 30000/1001 --no-frames --sound motion -o " + video);
    ASSERT_EQ(run.code, 0) << run.err;
    const json stream = probe(folder, video);
    EXPECT_EQ(stream["r_frame_rate"], "30000/1001") << video;
    EXPECT_EQ(stream["nb_read_frames"], "30");
  }
  std::ofstream(folder / "scene.toml")
      << "[body]\nmoments = [1, 2, 3]\n[film]\nfps = \"24000/1001\"\n";
  ASSERT_EQ(run_twrench(folder, film + "scene.toml -o b.mp4").code, 0);
  EXPECT_EQ(probe(folder, "b.mp4")["r_frame_rate"], "24000/1001");
  const json manifest = json::parse(text_of(folder / "b/manifest.json"));
  EXPECT_EQ(manifest["fps"], 24000.0 / 1001);
  EXPECT_EQ(manifest["scene"]["film"]["fps"], 24000.0 / 1001);
  EXPECT_EQ(manifest["frames"][10]["t"], 10 / (24000.0 / 1001));
  ASSERT_EQ(run_twrench(folder, "encode b --progress none -o c.mov").code, 0);
  EXPECT_EQ(probe(folder, "c.mov")["r_frame_rate"], "24000/1001");
  const Outcome wrong = run_twrench(folder, film + "--fps 30/0 -o d.mp4");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--fps: '30/0' is not a fraction"));
}

TEST(Render, ReportsAndSetsTheLengthOfTheVideo) {
  const ScratchFolder folder;
  const std::string film = "render --size 32x32 --bare --frames 0 --no-video --overwrite ";
  const auto described = [&](const std::string& options) {
    const Outcome run = run_twrench(folder, film + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err.substr(0, run.err.find('\n'));
  };
  EXPECT_EQ(described(""), "twrench: note: 96 s of motion, 6 times as fast: 16 s of video");
  EXPECT_EQ(described("--length 4"),
            "twrench: note: 24 s of motion, 6 times as fast: 4 s of video");
  EXPECT_EQ(described("--length 4 --speed 1"),
            "twrench: note: 4 s of motion, in real time: 4 s of video");
  EXPECT_EQ(described("--length 4 --duration 2"),
            "twrench: note: 2 s of motion, 0.5 times as fast: 4 s of video");
  EXPECT_THAT(described("--length 4 --inertia 3,4,5"), HasSubstr("4 s of video"));
  const Outcome wrong = run_twrench(folder, film + "--length 4 --duration 2 --speed 1");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--length: --duration and --speed determine it already"));
}

TEST(Render, WithoutAnOutputNamesTheFileByItsContainer) {
  const ScratchFolder folder;
  const std::string film =
      "render --size 32x32 --bare --duration 1 --speed 1 --fps 5 "
      "--progress none --no-frames --container ";
  for (const char* container : {"webp", "gif", "mkv"}) {
    ASSERT_EQ(run_twrench(folder, film + container).code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / ("out/dzhanibekov." + std::string(container))));
  }
}

TEST(Render, FilmAndFramesAndManifest) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, small_film);
  ASSERT_EQ(run.code, 0) << run.err;

  const json stream = probe(folder, "out/dzhanibekov.mp4");
  EXPECT_EQ(stream["codec_name"], "h264");
  EXPECT_EQ(stream["pix_fmt"], "yuv420p");
  EXPECT_EQ(stream["width"], 160);
  EXPECT_EQ(stream["height"], 90);
  EXPECT_EQ(stream["nb_read_frames"], "12");
  EXPECT_EQ(stream["r_frame_rate"], "10/1");
  for (const char* tag : {"color_space", "color_transfer", "color_primaries"}) {
    EXPECT_EQ(stream[tag], "bt709") << tag;
  }
  EXPECT_EQ(stream["color_range"], "tv");

  const json manifest = json::parse(text_of(folder / "out/dzhanibekov/manifest.json"));
  EXPECT_EQ(manifest["size"], json({160, 90}));
  EXPECT_EQ(manifest["fps"], 10);
  EXPECT_EQ(manifest["scene"]["motion"]["omega"], json({1.0, 0.05, 0.0}));
  ASSERT_EQ(manifest["frames"].size(), 12u);
  for (int i = 0; i < 12; ++i) {
    const json& frame = manifest["frames"][static_cast<std::size_t>(i)];
    EXPECT_EQ(frame["frame"], i);
    EXPECT_EQ(frame["t"], i * 6.0 / 10.0);
    const auto file = folder / ("out/dzhanibekov/" + frame["file"].get<std::string>());
    EXPECT_EQ(frame["sha256"], system::sha256_hex(system::read_file(file, 1 << 24)));
  }
}

// The pose in the manifest is that of a separate integration at the frame's time.
TEST(Render, FramesArePosedByTheTrajectory) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small_film + "--no-video --method rk4 --step 0.05").code, 0);
  const json manifest = json::parse(text_of(folder / "out/dzhanibekov/manifest.json"));
  const Outcome motion =
      run_twrench(folder, "simulate --method rk4 --step 0.05 --times 5.4 --format json");
  const json sample = json::parse(motion.out)["samples"][0];
  EXPECT_EQ(manifest["frames"][9]["t"], sample["t"]);
  EXPECT_EQ(manifest["frames"][9]["X"], sample["X"]);
}

TEST(Render, DecodedFramesAreThePngFrames) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small_film).code, 0);
  run_command("ffmpeg -v error -i '" + (folder / "out/dzhanibekov.mp4").string() +
              "' -vf scale=in_color_matrix=bt709:flags=accurate_rnd+full_chroma_int "
              "-pix_fmt rgb24 '" +
              (folder / "decoded_%06d.png").string() + "'");
  for (const int i : {0, 5, 11}) {
    char name[32];
    std::snprintf(name, sizeof name, "%06d.png", i);
    const image::Image png =
        image::read_png(folder / ("out/dzhanibekov/frame_" + std::string(name)));
    std::snprintf(name, sizeof name, "decoded_%06d.png", i + 1);
    const auto difference = image::compare(image::read_png(folder / name), png, 24);
    ASSERT_TRUE(difference.has_value());
    // Video keeps a quarter of the chroma samples, which affects thin coloured lines, and rounds
    // the rest; a wrong matrix or range would be off by far more than this everywhere.
    EXPECT_LE(difference->mean, 1.3) << i;
    EXPECT_LE(difference->share, 0.02) << i;
  }
}

TEST(Render, FramesDoNotDependOnTheRangeNorOnTheJobs) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small_film + "--no-video --frames-dir a --jobs 1").code, 0);
  ASSERT_EQ(
      run_twrench(folder, small_film + "--no-video --frames-dir b --jobs 3 --frames 11,4-6").code,
      0);
  for (const int i : {4, 5, 6, 11}) {
    const std::string name = "frame_0000" + std::string(i < 10 ? "0" : "") + std::to_string(i);
    EXPECT_EQ(text_of(folder / ("a/" + name + ".png")), text_of(folder / ("b/" + name + ".png")));
  }
  EXPECT_EQ(folder.names().size(), 4u);  // a, b, and the two outputs of the command
  EXPECT_FALSE(std::filesystem::exists(folder / "b/frame_000000.png"));
}

// The digest of each frame by number, from the manifest in `frames_dir`.
std::map<int, std::string> digests_by_number(const ScratchFolder& folder,
                                             const std::string& frames_dir) {
  const json manifest = json::parse(text_of(folder / (frames_dir + "/manifest.json")));
  std::map<int, std::string> result;
  for (const json& frame : manifest["frames"]) result[frame["frame"]] = frame["sha256"];
  return result;
}

TEST(Render, FramesDoNotDependOnWhatWasDrawnBeforeThem) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small_film + "--no-video --frames-dir whole --jobs 1").code, 0);
  std::vector<int> numbers(12);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::shuffle(numbers.begin(), numbers.end(), std::mt19937(5));
  std::map<int, std::string> together;
  for (int run = 0; run < 3; ++run) {  // four frames each, on one, two and three threads
    std::string range;
    for (int i = 4 * run; i < 4 * run + 4; ++i) {
      if (!range.empty()) range += ',';
      range += std::to_string(numbers[static_cast<std::size_t>(i)]);
    }
    std::string part("part");
    part += std::to_string(run);
    std::string options("--no-video --frames-dir ");
    options += part + " --jobs " + std::to_string(run + 1) + " --frames " + range;
    ASSERT_EQ(run_twrench(folder, small_film + options).code, 0);
    together.merge(digests_by_number(folder, part));
  }
  EXPECT_EQ(together, digests_by_number(folder, "whole"));
}

TEST(Render, EncodeMakesTheSameFilmFromTheFrames) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small_film).code, 0);
  const Outcome run = run_twrench(folder, "encode out/dzhanibekov -o again.mp4 --progress none");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto md5 = [&](const std::string& video) {
    run_command("ffmpeg -v error -i '" + (folder / video).string() + "' -f md5 '" +
                (folder / "md5.txt").string() + "' -y");
    return text_of(folder / "md5.txt");
  };
  EXPECT_EQ(md5("again.mp4"), md5("out/dzhanibekov.mp4"));
}

TEST(Render, TransparentFramesHaveTheBodysCoverageAsAlpha) {
  const ScratchFolder folder;
  ASSERT_EQ(
      run_twrench(folder, small_film + "--no-video --bare --background transparent --frames 0")
          .code,
      0);
  const image::Image image = image::read_png(folder / "out/dzhanibekov/frame_000000.png");
  ASSERT_EQ(image.channels, 4);
  EXPECT_EQ(image.pixels[3], 0);                                       // a corner
  EXPECT_EQ(image.pixels[(45 * 160 + 80) * std::size_t{4} + 3], 255);  // the centre of mass
}

TEST(Render, NoFramesLeavesTheFilmAlone) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small_film + "--no-frames -o 'a film.mp4'").code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "a film.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(Render, ProgressForPeopleAndForPrograms) {
  const ScratchFolder folder;
  const std::string base = "render --size 64x36 --no-video --frames 0-4 --progress ";
  const Outcome plain = run_twrench(folder, base + "auto");  // not a terminal
  EXPECT_THAT(plain.err, HasSubstr("5 of 5 frames, "));
  EXPECT_THAT(plain.err, HasSubstr("5 frames in "));
  const Outcome lines = run_twrench(folder, base + "json");
  EXPECT_EQ(json::parse(lines.err.substr(0, lines.err.find('\n')))["frames_total"], 5);
  EXPECT_THAT(run_twrench(folder, base + "bar").err, HasSubstr("] 5/5 "));
  EXPECT_EQ(run_twrench(folder, base + "none").err, "");
}

TEST(Render, TimingForPeopleAndForPrograms) {
  const ScratchFolder folder;
  const std::string base = "render --size 64x36 --frames 0-4 --progress none ";
  const Outcome text = run_twrench(folder, base + "--timing");
  EXPECT_THAT(text.err, HasSubstr("busy time per frame, ms: pose "));
  const json report = json::parse(run_twrench(folder, base + "--timing=json").err);
  EXPECT_EQ(report["frames"], 5);
  double wall = report["wall_seconds"];
  EXPECT_GT(report["first_frame_seconds"], 0.0);
  EXPECT_LT(report["first_frame_seconds"], wall);
  for (const char* stage :
       {"pose", "draw", "composite", "convert", "compress", "write", "encode"}) {
    EXPECT_GT(report["busy_ms_per_frame"][stage], 0.0) << stage;
  }
  EXPECT_GT(report["cpu_ms_per_frame"]["children"], 0.0) << "the encoder's";
}

// A substitute for ffmpeg that dies after some frames.
TEST(Render, FramesStayWhenFfmpegDies) {
  const ScratchFolder folder;
  system::write_file_atomically(
      folder / "ffmpeg",
      "#!/bin/sh\ncase \"$*\" in *null*) cat >/dev/null; exit 0;; esac\n"
      "head -c 100000 >/dev/null\necho 'the encoder is broken' >&2\nexit 7\n");
  std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
  const Outcome run =
      run_twrench(folder, small_film, "PATH='" + folder.path().string() + "':\"$PATH\" ");
  EXPECT_EQ(run.code, 4);
  EXPECT_THAT(run.err, HasSubstr("the encoder is broken"));
  EXPECT_THAT(run.err, HasSubstr("libx264"));  // the exact command
  EXPECT_TRUE(std::filesystem::exists(folder / "out/dzhanibekov/frame_000000.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/dzhanibekov/manifest.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/dzhanibekov.mp4"));
}

}  // namespace
}  // namespace twrench
