// Films with shots, with the real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/twrench.h"
#include "sanitizers.h"
#include "system/file.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string story = R"(
[body]
moments = [3, 4, 5]
[motion]
omega = [0.05, 1, 0]
method = "exact"
[film]
size = [192, 168]
fps = 5
speed = 3
[overlay]
show = ["floor"]
[[shot]]
length = 1
caption = "One & only"
[[shot]]
length = 1
fade = 0.6
move = 0.4
[shot.overlay]
show = ["floor", "omega"]
[[shot]]
length = 1
fade = 0.4
caption = "Three"
speed = [[0, 1], [0.5, 0]]
[shot.look]
theme = "paper"
)";

class Story : public testing::Test {
 protected:
  Story() { write(story); }

  void write(const std::string& text) const {
    system::write_file_atomically(folder / "story.toml", text);
  }
  Outcome render(const std::string& options) const {
    return run_twrench(folder, "render story.toml --progress none " + options);
  }
  json manifest(const std::string& frames = "out/story") const {
    return json::parse(text_of(folder / (frames + "/manifest.json")));
  }

  const ScratchFolder folder;
};

TEST_F(Story, IsAFilmWithFramesManifestAndCaptions) {
  const Outcome run = render("");
  ASSERT_EQ(run.code, 0) << run.err;
  const json all = manifest();
  ASSERT_EQ(all["frames"].size(), 15u);
  EXPECT_EQ(all["frames"][4]["t"], 0.8 * 3);
  EXPECT_EQ(all["frames"][5]["t"], 3);
  EXPECT_EQ(all["frames"][14]["t"], 6.25);
  EXPECT_EQ(all["scene"]["shot"].size(), 3u);
  EXPECT_EQ(text_of(folder / "out/story.vtt").substr(0, 21), "WEBVTT\n\nNOTE twrench:");
  EXPECT_THAT(text_of(folder / "out/story.vtt"),
              HasSubstr("\n00:00:00.000 --> 00:00:01.000\nOne &amp; only\n"
                        "\n00:00:02.000 --> 00:00:03.000\nThree\n"));
}

TEST_F(Story, ResumesToTheSameBytes) {
  ASSERT_EQ(render("--no-video --frames-dir whole").code, 0);
  ASSERT_EQ(render("--no-video --frames-dir some --frames 0-1,6,12").code, 0);
  ASSERT_EQ(render("--no-video --frames-dir some --resume").code, 0);
  EXPECT_EQ(digests(folder / "some"), digests(folder / "whole"));
}

TEST_F(Story, IsDrawnInShards) {
  ASSERT_EQ(render("--no-video --frames-dir whole").code, 0);
  for (const char* shard : {"1/3", "3/3", "2/3"}) {
    ASSERT_EQ(render(std::string("--frames-dir parts --shard ") + shard).code, 0);
  }
  EXPECT_EQ(digests(folder / "parts"), digests(folder / "whole"));
}

TEST_F(Story, ResumeSeesAChangeOfAnyShot) {
  ASSERT_EQ(render("--no-video --frames 0").code, 0);
  for (const auto& [old, changed] : {std::pair("Three", "Four"), {"fade = 0.4", "fade = 0.3"}}) {
    std::string other = story;
    other.replace(other.find(old), std::string(old).size(), changed);
    write(other);
    const Outcome run = render("--no-video --frames 0 --resume");
    EXPECT_EQ(run.code, 2) << old;
    EXPECT_THAT(run.err, HasSubstr("another scene"));
  }
}

TEST_F(Story, KeepsTheTimesOfAPartsCaptions) {
  ASSERT_EQ(render("--no-frames --frames 9-14 -o part.mp4").code, 0);
  EXPECT_THAT(text_of(folder / "part.vtt"), HasSubstr("\n00:00:00.200 --> 00:00:01.200\nThree\n"));
}

TEST_F(Story, ReplacesNoCaptionsOfSomethingElse) {
  system::write_file_atomically(folder / "film.vtt", "WEBVTT\n\nof another film");
  const Outcome refused = render("--no-frames -o film.mp4");
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(refused.err, HasSubstr("film.vtt"));
  EXPECT_FALSE(fs::exists(folder / "film.mp4"));
  EXPECT_EQ(render("--no-frames -o film.mp4 --overwrite").code, 0);
  EXPECT_EQ(render("--no-frames -o film.mp4").code, 0) << "the same film again";
  EXPECT_THAT(text_of(folder / "film.vtt"), HasSubstr("Three"));
}

TEST_F(Story, WritesCaptionsBesideFilesAlone) {
  const Outcome run = render("--no-frames -o - --container mkv >film.mkv");
  ASSERT_EQ(run.code, 0) << run.err;
  write("[body]\nmoments = [3, 4, 5]\n[film]\nsize = [32, 32]\nfps = 5\n[[shot]]\nlength = 1");
  ASSERT_EQ(render("--no-frames -o silent.mp4").code, 0);
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().extension(), ".vtt") << entry.path();
  }
}

TEST_F(Story, TakesOptionsThatMakeSenseForAllShots) {
  ASSERT_EQ(render("--no-video --size 64x36 --theme space --fps 2 --show axes").code, 0);
  const json all = manifest();
  EXPECT_EQ(all["frames"].size(), 6u);
  EXPECT_EQ(all["size"], json({64, 36}));
  for (const json& shot : all["scene"]["shot"]) EXPECT_FALSE(shot.contains("look")) << shot;
  for (const char* option :
       {"--omega 1,2,3", "--duration 3", "--speed 2", "--length 2", "--inertia 1,2,3"}) {
    const Outcome run = render(option);
    EXPECT_EQ(run.code, 2) << option;
    EXPECT_THAT(run.err, HasSubstr("each shot of story has its own"));
  }
}

TEST_F(Story, MayBeInAnyLanguage) {
  write("language = \"sv\"\n" + story);
  const std::string draw = "render story.toml --frames 0 --no-video --overwrite --frames-dir f";
  const Outcome run = run_twrench(folder, draw);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("note: the picture's own words, such as readouts, are in English, "
                                 "not in 'sv'"));
  EXPECT_EQ(manifest("f")["scene"]["language"], "sv");
  EXPECT_THAT(run_twrench(folder, draw + " --language no").err, Not(HasSubstr("own words")));
  EXPECT_EQ(manifest("f")["scene"]["language"], "nb");
  const Outcome wrong = render("--language svenska");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--language: 'svenska' is not the tag of a language"));
}

TEST_F(Story, NamesTheProgramThatFindsAFontForACaption) {
  std::string other = story;
  write(other.replace(other.find("Three"), 5, "\u0646"));
  const Outcome run = render("");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("caption: contains the character U+0646"));
  EXPECT_THAT(run.err, HasSubstr("--font FILE takes a font that has it: fc-list :charset=646 "));
  EXPECT_THAT(run.err, Not(HasSubstr("--title")));
}

TEST_F(Story, NamesTheFirstCaptionThatASmallPictureLeavesOut) {
  const std::string warning =
      "warning: story.toml:13: shot[0].caption: is left out, because a picture of 64x36 is too "
      "small";
  const Outcome run = render("--no-video --size 64x36");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr(warning));
  EXPECT_EQ(run.err.find("is left out"), run.err.rfind("is left out")) << "each film once";
  EXPECT_EQ(render("--no-video --frames-dir large").err.find("left out"), std::string::npos);
}

TEST_F(Story, IsItsOwnMotionForOtherCommands) {
  const Outcome run = run_twrench(folder, "simulate story.toml --times 2 --duration 3");
  EXPECT_EQ(run.code, 0) << run.err;
  write(story.substr(0, story.find("[[shot]]")));
  EXPECT_EQ(run_twrench(folder, "simulate story.toml --times 2 --duration 3").out, run.out);
}

TEST_F(Story, AMistakeNamesShotAndLine) {
  std::string other = story;
  other.replace(other.find("fade = 0.6"), 10, "fade = 1.6");
  write(other);
  const Outcome run = render("");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("story.toml:18: shot[1].fade: is 1.6 s, but must be at most 1 s"));
}

TEST(BuiltInStory, HasCaptionsInAnotherLanguage) {
  if (has_sanitizers) GTEST_SKIP() << "draws the same as other tests";
  const ScratchFolder folder;
  const std::string command =
      "render explain --size 64x36 --frames 130-131 --progress none --language ";
  ASSERT_EQ(run_twrench(folder, command + "nb -o clip.mp4").code, 0);
  EXPECT_THAT(text_of(folder / "clip.vtt"), HasSubstr("En vingemutter"));
  ASSERT_EQ(run_twrench(folder, command + "nb --no-video").code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/explain-nb/frame_000130.png"));
  const Outcome unknown = run_twrench(folder, command + "de");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("twrench: error: --language: explain is not told in 'de'"));
}

}  // namespace
}  // namespace twrench
