// The flips as chapters of a film, and films as animated images, with the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/twrench.h"
#include "run_command.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// 160 frames in 16 s. The body turns over at 11.8, 35.4, 59.1 and 82.7 s of motion, which the film
/// shows six times as fast.
const std::string small = "render --size 64x36 --fps 10 --show hud --progress none ";

/// The chapters according to ffprobe: start, end and title of each.
std::string chapters_in(const ScratchFolder& folder, const std::string& video) {
  const std::string out = (folder / (video + ".chapters")).string();
  run_command(
      "ffprobe -v error -show_chapters -of csv=p=0 -show_entries "
      "chapter=start_time,end_time:chapter_tags=title '" +
      (folder / video).string() + "' >'" + out + "'");
  return text_of(out);
}

/// The size and the number of frames according to ffprobe.
std::string stream_in(const ScratchFolder& folder, const std::string& video) {
  const std::string out = (folder / (video + ".stream")).string();
  run_command(
      "ffprobe -v error -count_frames -of csv=p=0 -show_entries "
      "stream=width,height,nb_read_frames '" +
      (folder / video).string() + "' >'" + out + "'");
  return text_of(out);
}

TEST(Chapters, AreTheFlips) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, small + "--no-frames -o film.mp4");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(chapters_in(folder, "film.mp4"),
            "0.000000,2.000000,start\n"
            "2.000000,6.000000,flip 1 at 11.8 s\n"
            "6.000000,9.900000,flip 2 at 35.4 s\n"
            "9.900000,13.800000,flip 3 at 59.1 s\n"
            "13.800000,16.000000,flip 4 at 82.7 s\n");
  EXPECT_THAT(text_of(folder / "film.chapters.vtt"),
              HasSubstr("\n00:00:06.000 --> 00:00:09.900\nflip 2 at 35.4 s\n"));
  EXPECT_FALSE(fs::exists(folder / "film.vtt"));
}

TEST(Chapters, OfAPartBeginWhereItDoes) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small + "--no-frames --frames 90-129:3 -o part.mkv").code, 0);
  EXPECT_EQ(chapters_in(folder, "part.mkv"),
            "0.000000,0.300000,flip 2 at 35.4 s\n"
            "0.300000,1.400000,flip 3 at 59.1 s\n");
  ASSERT_EQ(run_twrench(folder, small + "--no-frames --frames 30-40 -o none.mp4").code, 0);
  EXPECT_EQ(chapters_in(folder, "none.mp4"), "");
  EXPECT_FALSE(fs::exists(folder / "none.chapters.vtt"));
}

TEST(Chapters, AreLeftOutOnRequest) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, small + "--frames 0-29 --no-chapters -o film.mp4").code, 0);
  EXPECT_EQ(chapters_in(folder, "film.mp4"), "");
  EXPECT_FALSE(fs::exists(folder / "film.chapters.vtt"));
  ASSERT_EQ(run_twrench(folder, "encode film -o e.mp4 --progress none").code, 0);
  EXPECT_EQ(chapters_in(folder, "e.mp4"),
            "0.000000,2.000000,start\n2.000000,3.000000,flip 1 at 11.8 s\n");
  for (const char* wrong : {"--chapters --no-chapters -o x.mp4", "--chapters -o x.gif"}) {
    const Outcome run = run_twrench(folder, small + wrong);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("--chapters: "));
  }
}

const std::string chapters_story = R"(
[body]
moments = [3, 4, 5]
[motion]
omega = [0.2, 4, 0]
method = "exact"
[film]
size = [160, 168]
fps = 5
speed = 3
[overlay]
show = ["floor"]
[[shot]]
length = 1
caption = "One & only"
[[shot]]
length = 2
fade = 0.6
caption = "Two"
speed = [[0, 4], [1, 0]]
[[shot]]
length = 1
start = 30
[[shot]]
length = 1
start = 2
)";

// From a manifest of shards, encode makes the same chapters and captions.
TEST(Chapters, OfFramesAreThoseOfTheFilm) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "story.toml", chapters_story);
  const std::string command = "render story.toml --progress none ";
  ASSERT_EQ(run_twrench(folder, command + "-o film.mp4").code, 0);
  EXPECT_EQ(chapters_in(folder, "film.mp4"),
            "0.000000,1.400000,start\n"
            "1.400000,3.000000,flip 1 at 4.04 s\n"
            "3.000000,4.000000,flip 4 at 28.3 s\n"
            "4.000000,4.800000,start\n"
            "4.800000,5.000000,flip 1 at 4.04 s\n");
  const std::string chapters = text_of(folder / "film.chapters.vtt");
  const std::string captions = text_of(folder / "film.vtt");
  EXPECT_THAT(captions, HasSubstr("One &amp; only"));
  for (const char* shard : {"2/3", "1/3", "3/3"}) {
    ASSERT_EQ(run_twrench(folder, command + "--frames-dir parts --shard " + shard).code, 0);
  }
  ASSERT_EQ(run_twrench(folder, command + "--frames-dir some --no-video --frames 0-9:2").code, 0);
  ASSERT_EQ(run_twrench(folder, command + "--frames-dir some --no-video --resume").code, 0);
  for (const std::string frames : {"parts", "some"}) {
    const Outcome run = run_twrench(folder, "encode " + frames + " -o e.mp4 --progress none");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(chapters_in(folder, "e.mp4"), chapters_in(folder, "film.mp4"));
    EXPECT_EQ(text_of(folder / "e.chapters.vtt"), chapters);
    EXPECT_EQ(text_of(folder / "e.vtt"), captions);
  }
}

TEST(Chapters, AreOfTheCaptionsThatAManifestHas) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "story.toml", chapters_story);
  ASSERT_EQ(run_twrench(folder, "render story.toml --no-video --frames 0-1 --progress none").code,
            0);
  const fs::path path = folder / "out/story/manifest.json";
  const auto manifest = nlohmann::ordered_json::parse(text_of(path));
  for (const char* shots :
       {"7", "[]", "[7]", "[{}]", "[{\"caption\": 7}]", "{\"0\": {}}", "null"}) {
    auto other = manifest;
    other["scene"]["shot"] = nlohmann::json::parse(shots);
    system::write_file_atomically(path, other.dump());
    const Outcome run =
        run_twrench(folder, "encode out/story -o v.mp4 --overwrite --progress none");
    EXPECT_EQ(run.code, 0) << shots << run.err;
    EXPECT_FALSE(fs::exists(folder / "v.vtt")) << shots;
  }
}

TEST(AnimatedImages, AreDrawnSmall) {
  const ScratchFolder folder;
  for (const std::string name : {"film.gif", "film.webp"}) {
    const Outcome run = run_twrench(
        folder, "render --size 320x180 --frames 100-105 --bare --progress none -o " + name);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_FALSE(fs::exists(folder / "out")) << "no frames unless asked for";
    EXPECT_EQ(run_twrench(folder, "render --frames 100-101 --bare --progress none -o " + name).code,
              5)
        << "another film";
    ASSERT_EQ(run_twrench(folder,
                          "render --frames 100-105 --bare --progress none --frames-dir f "
                          "--overwrite -o " +
                              name)
                  .code,
              0);
    EXPECT_EQ(run_twrench(folder, "render --frames 100-105 --bare --progress none -o " + name).code,
              0)
        << "the same film again";
    const auto manifest = nlohmann::json::parse(text_of(folder / "f/manifest.json"));
    EXPECT_EQ(manifest["size"], nlohmann::json({640, 360})) << name;
    EXPECT_FALSE(fs::exists(folder / "film.chapters.vtt"));
  }
  EXPECT_EQ(stream_in(folder, "film.gif"), "640,360,3\n");
}

TEST(AnimatedImages, AreScaledFromFrames) {
  const ScratchFolder folder;
  const std::string frames =
      "render --size 1280x720 --samples 1 --frames 100-103 --bare --progress none ";
  ASSERT_EQ(run_twrench(folder, frames + "--no-video --frames-dir f").code, 0);
  ASSERT_EQ(run_twrench(folder, "encode f -o a.gif --progress none").code, 0);
  EXPECT_EQ(stream_in(folder, "a.gif"), "640,360,2\n");
  ASSERT_EQ(run_twrench(folder, "encode f -o b.gif --width 321 --progress none").code, 0);
  EXPECT_EQ(stream_in(folder, "b.gif"), "321,181,2\n");
  EXPECT_EQ(run_twrench(folder, "encode f -o c.webp --width 100 --progress none").code, 0);
  for (const char* wrong : {"--width 0", "--width 3.5", "--width x", "--width 100000"}) {
    EXPECT_EQ(run_twrench(folder, std::string("encode f -o d.gif ") + wrong).code, 2) << wrong;
  }
  const Outcome video = run_twrench(folder, "encode f -o d.mp4 --width 320");
  EXPECT_EQ(video.code, 2);
  EXPECT_THAT(video.err, HasSubstr("only GIF and WebP are scaled"));
  EXPECT_FALSE(fs::exists(folder / "d.mp4"));
}

TEST(AnimatedImages, GoToStandardOutput) {
  const ScratchFolder folder;
  for (const std::string kind : {"gif", "webp"}) {
    const Outcome run =
        run_shell(folder, "\"$TWRENCH\" " + small + "--frames 0-9 -o - --container " + kind +
                              " | cat >film." + kind);
    EXPECT_EQ(run.err, "") << kind;
    EXPECT_THAT(text_of(folder / ("film." + kind)).substr(0, 4), testing::AnyOf("GIF8", "RIFF"));
  }
  EXPECT_EQ(stream_in(folder, "film.gif"), "64,36,10\n");
}

TEST(AnimatedImages, OfATransparentFilmAreTransparent) {
  const ScratchFolder folder;
  const std::string command =
      "render --size 64x36 --frames 100-101 --bare --background transparent --progress none -o ";
  ASSERT_EQ(run_twrench(folder, command + "film.gif").code, 0);
  run_command("ffmpeg -v error -i '" + (folder / "film.gif").string() +
              "' -frames:v 1 -f rawvideo -pix_fmt rgba '" + (folder / "raw").string() + "'");
  const std::string raw = text_of(folder / "raw");
  ASSERT_EQ(raw.size(), 64u * 36 * 4);
  EXPECT_EQ(raw[3], '\0');
  EXPECT_EQ(raw[4 * (18 * 64 + 32) + 3], '\xFF');
}

}  // namespace
}  // namespace twrench
