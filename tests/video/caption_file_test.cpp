#include "video/caption_file.h"

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

TEST(CaptionFile, AppearsBesideItsVideoWhenItIsFinished) {
  const ScratchFolder folder;
  {
    CaptionFile file(folder / "film.mp4", cues, "twrench:1", false);
    EXPECT_FALSE(fs::exists(folder / "film.vtt"));
    file.finish();
  }
  EXPECT_EQ(text_in(folder / "film.vtt"), web_vtt(cues, "twrench:1"));
  { const CaptionFile given_up(folder / "other.mp4", cues, "twrench:1", false); }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(CaptionFile, ReplacesOnlyItsOwn) {
  const ScratchFolder folder;
  CaptionFile(folder / "film.mp4", cues, "twrench:1", false).finish();
  EXPECT_NO_THROW(CaptionFile(folder / "film.mp4", cues, "twrench:1", false).finish());
  EXPECT_THROW(CaptionFile(folder / "film.webm", cues, "twrench:2", false), system::OverwriteError);
  EXPECT_NO_THROW(CaptionFile(folder / "film.mp4", cues, "twrench:2", true).finish());
  EXPECT_EQ(text_in(folder / "film.vtt"), web_vtt(cues, "twrench:2"));
}

}  // namespace
}  // namespace twrench::video
