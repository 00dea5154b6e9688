// An interrupted or killed run leaves only intact files, and can be resumed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "cli/held_run.h"
#include "cli/twrench.h"
#include "run_command.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

const std::string resumed_film =
    "--size 160x90 --fps 5 --speed 6 --duration 96 --frames-dir f -o v.mp4 ";  // 80 frames
const std::string held_command = "render --progress none " + resumed_film;

/// The digests in the manifest.
std::map<std::string, std::string> told_digests(const fs::path& folder) {
  std::map<std::string, std::string> told;
  const json manifest = json::parse(text_of(folder / "manifest.json"));
  for (const json& frame : manifest["frames"]) {
    told[frame["file"]] = frame["sha256"];
  }
  return told;
}

std::string decoded(const fs::path& video) {
  const fs::path sums = video.string() + ".md5";
  run_command("ffmpeg -v error -y -i '" + video.string() + "' -f framemd5 '" + sums.string() + "'");
  return text_of(sums);
}

/// A run of the command without interruption.
struct Undisturbed {
  explicit Undisturbed(const std::string& command) {
    EXPECT_EQ(run_twrench(folder, command).code, 0);
    frames = digests(folder / "f");
    video = decoded(folder / "v.mp4");
  }
  ScratchFolder folder;
  std::map<std::string, std::string> frames;
  std::string video;
};

TEST(Resume, AfterSignalsThatEndTheRunWhole) {
  const Undisturbed whole(held_command);
  ASSERT_EQ(whole.frames.size(), 80u);
  const std::pair<const char*, int> signals[] = {{"INT", 130}, {"TERM", 143}};
  for (const auto& [signal, code] : signals) {
    ScratchFolder folder;
    const Outcome stopped = run_shell(folder, start_held(resumed_film) + "kill -" + signal +
                                                  " $pid; kill -" + signal + " $pid; wait $pid");
    ASSERT_EQ(stopped.code, code) << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr(std::string("interrupted by SIG") + signal));
    EXPECT_THAT(stopped.err, HasSubstr("--resume"));
    EXPECT_EQ(digests(folder / "f"), told_digests(folder / "f"));
    EXPECT_LT(digests(folder / "f").size(), 80u);
    EXPECT_FALSE(fs::exists(folder / "v.mp4"));

    const Outcome resumed = run_twrench(folder, held_command + "--resume");
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(digests(folder / "f"), whole.frames);
    EXPECT_EQ(told_digests(folder / "f"), whole.frames);
    EXPECT_EQ(decoded(folder / "v.mp4"), whole.video);
  }
}

// 240 frames, which take about a second.
const std::string long_command =
    "render --progress none --size 160x90 --fps 15 --speed 6 --duration 96 --frames-dir f -o "
    "v.mp4 ";

// At times throughout the run, including its very start and end.
TEST(Resume, AfterBeingKilledAtAnyInstant) {
  const Undisturbed whole(long_command);
  ScratchFolder folder;
  for (int i = 0; i < 12; ++i) {
    const std::string seconds = "0." + std::to_string(100 + 73 * i);
    run_twrench(folder, long_command + "--resume", "timeout -s KILL " + seconds + " ");
    if (!fs::exists(folder / "f")) continue;
    for (const auto& [name, digest] : digests(folder / "f")) {
      EXPECT_EQ(whole.frames.at(name), digest) << name << " after " << seconds << " s";
    }
  }
  ASSERT_EQ(run_twrench(folder, long_command + "--resume").code, 0);
  EXPECT_EQ(digests(folder / "f"), whole.frames);
  EXPECT_EQ(told_digests(folder / "f"), whole.frames);
  EXPECT_EQ(decoded(folder / "v.mp4"), whole.video);
}

const std::string short_command =
    "render --size 64x36 --frames 0-9 --no-video --progress none --frames-dir f ";

TEST(Resume, TrustsNoFileBecauseItExists) {
  ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, short_command).code, 0);
  const auto before = digests(folder / "f");
  const auto untouched = fs::last_write_time(folder / "f/frame_000003.png");
  system::write_file_atomically(folder / "f/frame_000004.png", "damaged");
  fs::remove(folder / "f/frame_000007.png");
  fs::copy_file(folder / "f/frame_000001.png", folder / "f/frame_000008.png",
                fs::copy_options::overwrite_existing);
  ASSERT_EQ(run_twrench(folder, short_command + "--resume").code, 0);
  EXPECT_EQ(digests(folder / "f"), before);
  EXPECT_EQ(fs::last_write_time(folder / "f/frame_000003.png"), untouched) << "drawn again";
}

TEST(Resume, RefusesWhatIsOfAnotherScene) {
  ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, short_command + "--omega 1,0.2,0").code, 0);
  const auto other = digests(folder / "f");
  const Outcome refused = run_twrench(folder, short_command + "--resume");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("frames of another scene"));
  EXPECT_EQ(digests(folder / "f"), other);
  EXPECT_EQ(told_digests(folder / "f"), other);
}

TEST(Resume, RefusesAManifestOfSomebodyElse) {
  ScratchFolder folder;
  fs::create_directory(folder / "f");
  const std::string theirs = "{\"name\": \"a web application\"}\n";
  system::write_file_atomically(folder / "f/manifest.json", theirs);
  const Outcome refused = run_twrench(folder, short_command + "--resume");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("not written by this program"));
  EXPECT_EQ(text_of(folder / "f/manifest.json"), theirs);
}

TEST(Resume, KnowsTheFontByItsBytes) {
  ScratchFolder folder;
  fs::copy_file(TWRENCH_SANS_FILE, folder / "font.ttf");
  const std::string with_font = short_command + "--font ./font.ttf --resume ";
  ASSERT_EQ(run_twrench(folder, with_font).code, 0);
  EXPECT_EQ(run_twrench(folder, with_font).code, 0);
  ASSERT_EQ(run_shell(folder, "chmod u+w font.ttf && echo >>font.ttf").code, 0);
  const Outcome refused = run_twrench(folder, with_font);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("font"));
}

TEST(Overwrite, IsAskedForBeforeAnotherFilmIsDestroyed) {
  ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, short_command).code, 0);
  EXPECT_EQ(run_twrench(folder, short_command).code, 0) << "the same film again loses nothing";
  const auto before = digests(folder / "f");
  const Outcome other = run_twrench(folder, short_command + "--background white");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("another scene"));
  EXPECT_THAT(other.err, HasSubstr("--overwrite"));
  EXPECT_EQ(digests(folder / "f"), before);
  EXPECT_EQ(run_twrench(folder, short_command + "--background white --overwrite").code, 0);
  EXPECT_NE(digests(folder / "f"), before);
}

TEST(Overwrite, FramesWithoutAManifestAreSomebodys) {
  ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, short_command).code, 0);
  fs::remove(folder / "f/manifest.json");
  const Outcome refused = run_twrench(folder, short_command);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("frames without a manifest"));
  EXPECT_THAT(refused.err, HasSubstr("twrench compare OLD NEW --update"));
  EXPECT_EQ(run_twrench(folder, short_command + "--resume").code, 2);
  const Outcome both = run_twrench(folder, short_command + "--resume --overwrite");
  EXPECT_EQ(both.code, 2);
  EXPECT_EQ(both.err,
            "twrench: error: render: --resume keeps frames and --overwrite replaces them\n"
            "  give one of the two\n");
  EXPECT_EQ(run_twrench(folder, short_command + "--overwrite").code, 0);
}

TEST(Manifest, ListsAllRangesOfAFilm) {
  ScratchFolder folder;
  const std::string range =
      "render --size 64x36 --no-video --progress none --frames-dir f --frames ";
  ASSERT_EQ(run_twrench(folder, range + "0-4").code, 0);
  ASSERT_EQ(run_twrench(folder, range + "10-12").code, 0);
  EXPECT_EQ(told_digests(folder / "f").size(), 8u);
  EXPECT_EQ(told_digests(folder / "f"), digests(folder / "f"));
}

}  // namespace
}  // namespace twrench
