#include "video/text_tracks.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "scratch_folder.h"
#include "system/error.h"

namespace twrench::video {
namespace {

namespace fs = std::filesystem;

std::string text_in(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

const std::vector<Cue> cues{{0, 1.5, "L stays & ω wanders"}, {3599.9996, 7200.25, "a --> <b>\nc"}};

TEST(WebVtt, HasTimesAndTextsThatMeanNothingElse) {
  EXPECT_EQ(web_vtt(cues, "twrench:1"),
            "WEBVTT\n\nNOTE twrench:1\n"
            "\n00:00:00.000 --> 00:00:01.500\nL stays &amp; ω wanders\n"
            "\n01:00:00.000 --> 02:00:00.250\na --&gt; &lt;b&gt; c\n");
}

TEST(Cues, AreRunsOfFramesWithTheSameText) {
  const std::vector<std::string> texts{"a", "a", "", "b", "b", "b", "a"};
  const auto found = cues_of(texts.size(), 4, [&](std::size_t i) { return texts[i]; });
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(web_vtt(found, "x"),
            "WEBVTT\n\nNOTE x\n\n00:00:00.000 --> 00:00:00.500\na\n"
            "\n00:00:00.750 --> 00:00:01.500\nb\n\n00:00:01.500 --> 00:00:01.750\na\n");
}

TEST(Chapters, AreNoneWhereTheyWouldBeOne) {
  EXPECT_TRUE(chapters_of(5, 4, [](std::size_t) { return "start"; }).empty());
  EXPECT_EQ(chapters_of(5, 4, [](std::size_t i) { return i < 2 ? "a" : "b"; }).size(), 2u);
}

TEST(Chapters, AreNamedAfterTheLastFlip) {
  EXPECT_EQ(chapter_title(0, 0), "start");
  EXPECT_EQ(chapter_title(2, 35.4461), "flip 2 at 35.4 s");
  EXPECT_EQ(chapter_title(1, 0.31254), "flip 1 at 0.313 s");
}

// A player that jumps to a chapter shows the frame at that millisecond.
TEST(Chapters, BeginNoEarlierThanTheirFrames) {
  EXPECT_EQ(chapter_metadata({{0, 1.0 / 60, "start"}, {1.0 / 60, 3, "flip 1 at 2 s"}}),
            ";FFMETADATA1\n[CHAPTER]\nTIMEBASE=1/1000\nSTART=0\nEND=17\ntitle=start\n"
            "[CHAPTER]\nTIMEBASE=1/1000\nSTART=17\nEND=3000\ntitle=flip 1 at 2 s\n");
}

const TextTracks tracks{cues, {{0, 1, "start"}, {1, 2, "flip 1 at 3 s"}}};

TEST(TextTrackFiles, AppearBesideTheVideoWhenTheyAreFinished) {
  const ScratchFolder folder;
  {
    TextTrackFiles files(folder / "film.mp4", Container::mp4, tracks, {"twrench:1"}, false);
    EXPECT_FALSE(fs::exists(folder / "film.vtt"));
    files.finish();
  }
  EXPECT_EQ(text_in(folder / "film.vtt"), web_vtt(tracks.captions, "twrench:1"));
  EXPECT_EQ(text_in(folder / "film.chapters.vtt"), web_vtt(tracks.chapters, "twrench:1"));
  {
    const TextTrackFiles given_up(folder / "other.mp4", Container::mp4, tracks, {"twrench:1"},
                                  false);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST(TextTrackFiles, AreNotWrittenForEmptyTracksNorBesideDevices) {
  const ScratchFolder folder;
  TextTrackFiles(folder / "film.mp4", Container::mp4, {{}, tracks.chapters}, {"twrench:1"}, false)
      .finish();
  EXPECT_FALSE(fs::exists(folder / "film.vtt"));
  EXPECT_TRUE(fs::exists(folder / "film.chapters.vtt"));
  TextTrackFiles("/dev/null", Container::mp4, tracks, {"twrench:1"}, false).finish();
  TextTrackFiles("-", Container::mp4, tracks, {"twrench:1"}, false).finish();
  EXPECT_FALSE(fs::exists("/dev/null.vtt"));
  EXPECT_FALSE(fs::exists("-.vtt"));
}

TEST(TextTrackFiles, ReplaceOnlyTheirOwn) {
  const ScratchFolder folder;
  TextTrackFiles(folder / "film.mp4", Container::mp4, tracks, {"twrench:1"}, false).finish();
  EXPECT_NO_THROW(
      TextTrackFiles(folder / "film.mp4", Container::mp4, tracks, {"twrench:1"}, false).finish());
  EXPECT_THROW(TextTrackFiles(folder / "film.webm", Container::webm, tracks, {"twrench:2"}, false),
               system::OverwriteError);
  EXPECT_THROW(TextTrackFiles(folder / "film.webm", Container::webm, {{}, tracks.chapters},
                              {"twrench:2"}, false),
               system::OverwriteError);
  EXPECT_NO_THROW(
      TextTrackFiles(folder / "film.mp4", Container::mp4, tracks, {"twrench:2"}, true).finish());
  EXPECT_EQ(text_in(folder / "film.vtt"), web_vtt(cues, "twrench:2"));
}

TEST(TextTrackFiles, RemoveTheirOwnThatAreOutdated) {
  const ScratchFolder folder;
  const auto left = [&] { return fs::exists(folder / "film.chapters.vtt"); };
  TextTrackFiles(folder / "film.mp4", Container::mp4, tracks, {"twrench:1"}, false).finish();
  TextTrackFiles(folder / "film.mp4", Container::mp4, {}, {"twrench:2"}, false).finish();
  EXPECT_TRUE(left());
  { const TextTrackFiles given_up(folder / "film.mp4", Container::mp4, {}, {"twrench:1"}, false); }
  EXPECT_TRUE(left());
  TextTrackFiles(folder / "film.mp4", Container::mp4, {cues, {}}, {"twrench:1"}, false).finish();
  EXPECT_FALSE(left());
  EXPECT_TRUE(fs::exists(folder / "film.vtt"));
  TextTrackFiles(folder / "film.mp4", Container::mp4, {}, {"twrench:2"}, true).finish();
  EXPECT_FALSE(fs::exists(folder / "film.vtt"));
  std::ofstream(folder / "film.vtt") << "WEBVTT\n\nof a user's own";
  TextTrackFiles(folder / "film.mp4", Container::mp4, {}, {"twrench:2"}, true).finish();
  EXPECT_TRUE(fs::exists(folder / "film.vtt"));
}

}  // namespace
}  // namespace twrench::video
