// Outputs: no output overwrites an input or an unrelated file, and errors are reported before any
// file is created.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/held_run.h"
#include "cli/twrench.h"
#include "run_command.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const std::string picture = "--size 64x36 --frames 0-4 --progress none ";
const std::string film_command = "render " + picture + "--no-frames ";
const std::string frames_command = "render " + picture + "--no-video --frames-dir f ";

void expect_refused(const Outcome& run, int code, const std::string& message) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_THAT(run.err, StartsWith("twrench: error: "));
  EXPECT_THAT(run.err, HasSubstr(message));
}

std::int64_t frames_of(const ScratchFolder& folder, const std::string& video) {
  run_command("ffprobe -v error -count_packets -of csv=p=0 -show_entries stream=nb_read_packets '" +
              (folder / video).string() + "' >'" + (folder / "count").string() + "'");
  return std::stoll(text_of(folder / "count"));
}

TEST(Outputs, OfOneCommandAreDifferentFiles) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "simulate --times 0,1,2 -o run.csv").code, 0);
  ASSERT_EQ(run_twrench(folder, frames_command).code, 0);
  fs::create_symlink("x.svg", folder / "x.txt");
  fs::create_symlink("nowhere/d", folder / "d.png");
  fs::create_symlink("./nowhere/d", folder / "d.html");
  const auto before = folder.names().size();
  for (const char* command :
       {"check run.csv -o x.txt --plot ./x.svg", "study --methods rk4 -o x.txt --plot x.svg",
        "compare f/frame_000000.png f/frame_000001.png --diff d.png --report ./d.html"}) {
    expect_refused(run_twrench(folder, command), 2, "two outputs of this command");
  }
  EXPECT_EQ(folder.names().size(), before);
}

// The dynamic loader prints a warning to standard error in every program, including ffprobe.
TEST(Outputs, AreKeptWhenChildrenPrintWarnings) {
  const ScratchFolder folder;
  const std::string warning = "LD_PRELOAD=/nonexistent.so ";
  EXPECT_EQ(run_twrench(folder, film_command + "-o a.mp4", warning).code, 0);
  EXPECT_EQ(frames_of(folder, "a.mp4"), 5);
  ASSERT_EQ(run_twrench(folder, frames_command).code, 0);
  EXPECT_EQ(run_twrench(folder, "encode f -o b.mp4 --progress none", warning).code, 0);
  EXPECT_EQ(frames_of(folder, "b.mp4"), 5);
  EXPECT_THAT(run_twrench(folder, "doctor", warning).out, HasSubstr("ffmpeg version"));
}

TEST(Outputs, OnStandardOutputAreSummarized) {
  const ScratchFolder folder;
  const Outcome run = run_shell(
      folder, "\"$TWRENCH\" render --size 64x36 --frames 0-4 --no-frames -o - | cat >a.mp4");
  EXPECT_THAT(run.err, HasSubstr("; video on standard output\n"));
}

// The film does not exist when the second run checks, and its ffmpeg waits until the first run has
// ended.
TEST(Outputs, OfTwoRunsAtOnceAreNotBothDone) {
  const ScratchFolder folder;
  fs::create_directories(folder / "bin");
  system::write_file_atomically(
      folder / "bin/ffmpeg",
      "#!/bin/sh\ntouch started\nuntil [ -e go ]; do sleep 0.01; done\nPATH=\"$OLD_PATH\" exec "
      "ffmpeg \"$@\"\n");
  fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
  const Outcome run = run_shell(folder,
                                "export OLD_PATH=\"$PATH\"; "
                                "{ PATH=\"$PWD/bin:$PATH\" \"$TWRENCH\" " +
                                    film_command +
                                    "stable-y -o new/a.mp4; "
                                    "echo $? >second; } & "
                                    "until [ -e started ]; do sleep 0.01; done; "
                                    "\"$TWRENCH\" " +
                                    film_command +
                                    "-o new/a.mp4; code=$?; cp new/a.mp4 first.mp4; touch go; "
                                    "wait; exit $code");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(text_of(folder / "second"), "5\n");
  EXPECT_THAT(run.err, HasSubstr("it exists and is a different video"));
  EXPECT_EQ(text_of(folder / "new/a.mp4"), text_of(folder / "first.mp4"));
}

TEST(Outputs, AreNeverInputs) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, frames_command).code, 0);
  const std::string scene = "[[part]]\nshape = \"box\"\nsize = [1, 2, 3]\ndensity = 1\n";
  system::write_file_atomically(folder / "my.toml", scene);
  fs::create_symlink("my.toml", folder / "link.mp4");
  fs::create_hard_link(folder / "f/manifest.json", folder / "manifest.mp4");
  fs::create_symlink("f/frame_000003.png", folder / "frame.mp4");
  const auto before = digests(folder / "f");
  const std::string manifest = text_of(folder / "f/manifest.json");
  for (const std::string& command :
       {film_command + "my.toml -o my.toml", film_command + "my.toml -o link.mp4 --overwrite",
        std::string("simulate my.toml -o my.toml"), std::string("inertia my.toml -o ./my.toml"),
        std::string("study my.toml -o my.toml"), std::string("export my.toml -o my.toml"),
        std::string("plot my.toml -o my.toml"),
        std::string("compare f/frame_000000.png f/frame_000001.png --diff f/frame_000000.png"),
        std::string("compare f/frame_000000.png f/frame_000001.png --diff f/frame_000001.png"),
        std::string("encode f -o f/manifest.json --overwrite"),
        std::string("encode f -o f/frame_000003.png --overwrite"),
        std::string("encode f -o manifest.mp4 --overwrite --progress none"),
        std::string("encode f -o frame.mp4 --overwrite --progress none")}) {
    const Outcome run = run_twrench(folder, command);
    EXPECT_EQ(run.code, 2) << command << ": " << run.err;
  }
  EXPECT_EQ(text_of(folder / "my.toml"), scene);
  EXPECT_EQ(digests(folder / "f"), before);
  EXPECT_EQ(text_of(folder / "f/manifest.json"), manifest);
}

TEST(Outputs, AFilmOfAnotherSceneIsNotReplacedUnasked) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, film_command + "-o v.mp4").code, 0);
  EXPECT_EQ(run_twrench(folder, film_command + "-o v.mp4").code, 0)
      << "the same film again loses nothing";
  const std::string before = text_of(folder / "v.mp4");
  expect_refused(run_twrench(folder, film_command + "stable-y -o v.mp4"), 5, "a different video");
  ASSERT_EQ(run_twrench(folder, frames_command + "stable-y").code, 0);
  expect_refused(run_twrench(folder, "encode f -o v.mp4 --progress none"), 5, "a different video");
  EXPECT_EQ(text_of(folder / "v.mp4"), before);
  EXPECT_EQ(run_twrench(folder, "encode f -o v.mp4 --progress none --overwrite").code, 0);
  EXPECT_NE(text_of(folder / "v.mp4"), before);
  system::write_file_atomically(folder / "notes.mkv", "not a film");
  expect_refused(run_twrench(folder, film_command + "-o notes.mkv"), 5, "not a video");
  EXPECT_EQ(text_of(folder / "notes.mkv"), "not a film");
}

TEST(Outputs, BelongToOneRunAtATime) {
  const ScratchFolder folder;
  const std::string film = "--size 160x90 ";
  const std::string same = "\"$TWRENCH\" render --progress none " + film;
  const Outcome run =
      run_shell(folder, start_held(film + "-o v.mp4 --frames-dir f") + same +
                            "--no-frames -o v.mp4; echo film $?; " + same +
                            "--no-video --frames-dir f; echo frames $?; " + same +
                            "--frames-dir f --shard 1/2; echo shard $?; kill -KILL $pid; wait "
                            "$pid; " +
                            same + "--frames 0-4 --frames-dir f -o v.mp4; echo after $?");
  EXPECT_EQ(run.out, "film 5\nframes 5\nshard 5\nafter 0\n") << run.err;
  EXPECT_THAT(run.err, HasSubstr("another run is writing"));
}

TEST(Outputs, AShardBelongsToOneRunAtATime) {
  const ScratchFolder folder;
  const std::string shards = "--size 160x90 --fps 10 --frames-dir f ";
  const std::string other = "\"$TWRENCH\" render --progress none " + shards;
  const Outcome run =
      run_shell(folder, start_held(shards + "--shard 1/9") + other + "--shard 1/9; echo same $?; " +
                            other + "--shard 9/9; echo other $?; kill -KILL $pid; wait $pid; " +
                            other + "--shard 1/9 --resume; echo after $?");
  EXPECT_EQ(run.out, "same 5\nother 0\nafter 0\n") << run.err;
  EXPECT_THAT(run.err, HasSubstr("manifest.0001-of-0009.json: another run is writing it"));
}

TEST(Outputs, NamesAreChosenBeforeTheFirstFrame) {
  const ScratchFolder folder;
  fs::create_directory(folder / "folder.mp4");
  const std::string both = "render " + picture + "--frames-dir f -o ";
  for (const std::string& name : {std::string("out/x"), std::string("x.apng"), std::string("x.xyz"),
                                  std::string("x.txt"), std::string("x.mp4.")}) {
    expect_refused(run_twrench(folder, both + name), 2, ".webm");
  }
  expect_refused(run_twrench(folder, both + "folder.mp4"), 5, "it is a folder");
  expect_refused(run_twrench(folder, both + std::string(252, 'n') + ".mp4"), 5, "too long");
  EXPECT_FALSE(fs::exists(folder / "f"));
  EXPECT_FALSE(fs::exists(folder / "out"));
  EXPECT_EQ(run_twrench(folder, film_command + "-o " + std::string(251, 'n') + ".MP4").code, 0);
  EXPECT_EQ(run_twrench(folder, film_command + "-o x.MoV").code, 0);
}

// --encode small reorders frames.
TEST(Outputs, AFilmOnStandardOutputStartsAtZero) {
  const ScratchFolder folder;
  for (const std::string container : {"mp4", "mkv", "mov"}) {
    const Outcome run = run_shell(
        folder, "\"$TWRENCH\" " + film_command + "-o - --encode small --container " + container +
                    " >v && ffprobe -v error -of csv=p=0 -show_entries stream=start_time v");
    EXPECT_EQ(run.out, "0.000000\n") << container << run.err;
  }
}

TEST(Outputs, AFilmIsWrittenToStandardOutput) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, frames_command).code, 0);
  for (const char* const container : {"mp4", "mkv", "webm", "mov"}) {
    const std::string option = std::string("--container ") + container;
    const std::string video = std::string("v.") + container;
    const Outcome rendered =
        run_shell(folder, "\"$TWRENCH\" " + film_command + "-o - " + option + " | cat >" + video);
    EXPECT_EQ(rendered.err, "");
    EXPECT_EQ(frames_of(folder, video), 5);
    const Outcome encoded = run_shell(
        folder, "\"$TWRENCH\" encode f -o - --progress none " + option + " | cat >" + video);
    EXPECT_EQ(encoded.err, "");
    EXPECT_EQ(frames_of(folder, video), 5);
  }
  EXPECT_FALSE(fs::exists(folder / "-"));
  expect_refused(run_twrench(folder, "render --no-frames -o - --progress openjd"), 2, "openjd");
  expect_refused(run_twrench(folder, film_command + "-o - --container apng"), 2, "apng");
  const Outcome gone =
      run_shell(folder,
                "{ \"$TWRENCH\" render --size 320x180 --progress none --no-frames -o -; "
                "echo $? >code; } | head -c 100 >/dev/null");
  EXPECT_EQ(text_of(folder / "code"), "5\n") << gone.err;
  for (const std::string& command : {film_command, std::string("encode f ")}) {
    expect_refused(run_shell(folder, "\"$TWRENCH\" " + command + "-o - >&-"), 5,
                   "cannot write standard output: Bad file descriptor");
  }
}

TEST(Outputs, ThatAreDevicesAreWrittenTo) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "simulate --times 1 -o /dev/null").code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Outcome run = run_shell(
      folder, "{ echo first; \"$TWRENCH\" inertia -o /dev/stdout; } >all && head -n 2 all");
  EXPECT_THAT(run.out, StartsWith("first\nscene "));
  EXPECT_TRUE(fs::is_symlink("/dev/stdout"));
}

TEST(Outputs, ATransparentFilmNeedsAContainerThatKeepsAlpha) {
  const ScratchFolder folder;
  const std::string clear = "render --bare --background transparent " + picture;
  for (const std::string output : {"", "-o v.mp4", "-o my/v.MKV", "-o - --container mp4 >/dev/null",
                                   "-o v.webm --container mkv --no-frames"}) {
    const Outcome run = run_twrench(folder, clear + output);
    expect_refused(run, 2, "it cannot keep a transparent background");
    EXPECT_THAT(run.err, HasSubstr(".mov or .webm"));
  }
  EXPECT_EQ(folder.names().size(), 2u) << "only what the shell wrote, no file or folder";
  ASSERT_EQ(run_twrench(folder, clear + "--no-video --frames-dir f").code, 0);
  expect_refused(run_twrench(folder, "encode f -o new/v.mp4 --progress none"), 2, ".mov or .webm");
  EXPECT_FALSE(fs::exists(folder / "new"));
  for (const char* name : {"v.mov", "v.webm", "v.webp", "v.gif"}) {
    EXPECT_EQ(run_twrench(folder, std::string("encode f --progress none -o ") + name).code, 0);
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  }
}

TEST(Outputs, FramesAreInAFolderNamedAfterTheVideo) {
  const ScratchFolder folder;
  const std::string film = "render " + picture;
  ASSERT_EQ(run_twrench(folder, film + "-o my/clip.webm").code, 0);
  ASSERT_EQ(run_twrench(folder, film + "stable-y -o 'my/v 1.0.mp4'").code, 0);
  EXPECT_EQ(digests(folder / "my/clip").size(), 5u);
  EXPECT_EQ(digests(folder / "my/v 1.0").size(), 5u);
  EXPECT_FALSE(fs::exists(folder / "out"));
  const auto written = fs::last_write_time(folder / "my/clip/frame_000000.png");
  EXPECT_EQ(run_twrench(folder, film + "-o my/clip.webm --resume").code, 0);
  EXPECT_EQ(fs::last_write_time(folder / "my/clip/frame_000000.png"), written) << "drawn again";
  EXPECT_EQ(run_twrench(folder, "encode my/clip -o my/clip.mp4 --progress none").code, 0);
  expect_refused(run_twrench(folder, film + "stable-y -o my/clip.mkv"), 2,
                 "my/clip: contains frames of another scene");
}

TEST(Outputs, FramesAreInAFolderNamedAfterTheSceneIfTheVideoHasNoName) {
  for (const std::string output :
       {"", "-o - >v.mp4", "-o /dev/null --container mkv", "-o film --container mp4", "-o ..mp4"}) {
    const ScratchFolder folder;
    ASSERT_EQ(run_twrench(folder, "render " + picture + output).code, 0) << output;
    EXPECT_EQ(digests(folder / "out/dzhanibekov").size(), 5u) << output;
  }
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "render " + picture + "-o v.gif").code, 0);
  EXPECT_EQ(folder.names().size(), 3u) << "the GIF, and what the shell wrote";
}

TEST(Outputs, TheFolderOfFramesIsNotTheVideo) {
  const ScratchFolder folder;
  for (const std::string output : {"--frames-dir v.mp4 -o v.mp4", "--frames-dir v.mp4/ -o v.mp4",
                                   "--frames-dir ./v.mp4 -o x/../v.mp4"}) {
    const Outcome run = run_twrench(folder, "render " + picture + output);
    EXPECT_EQ(run.code, 2) << output << run.err;
    EXPECT_FALSE(fs::exists(folder / "v.mp4")) << output;
  }
  system::write_file_atomically(folder / "v", "a file");
  expect_refused(run_twrench(folder, "render " + picture + "-o v.mp4"), 5, "the folder v");
  EXPECT_EQ(text_of(folder / "v"), "a file");
  EXPECT_FALSE(fs::exists(folder / "v.mp4"));
}

TEST(Outputs, FoldersAreMadeForAFilm) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, frames_command).code, 0);
  EXPECT_EQ(run_twrench(folder, "encode f -o new/folder/v.mp4 --progress none").code, 0);
  EXPECT_TRUE(fs::exists(folder / "new/folder/v.mp4"));
}

// A manifest may be hostile: it must neither block us nor exhaust the memory.
TEST(Hostile, AManifestThatDoesNotEnd) {
  const ScratchFolder folder;
  fs::create_directory(folder / "f");
  for (const char* manifest :
       {"ln -s /dev/zero f/manifest.json", "mkfifo f/manifest.json",
        "{ printf '{\"version\": \"'; truncate -s 6G /dev/stdout; } >f/manifest.json"}) {
    ASSERT_EQ(run_shell(folder, std::string("rm -f f/manifest.json; ") + manifest).code, 0);
#if defined(TWRENCH_SANITIZED)  // they reserve all memory
    const std::string limit;
#else
    // Less than the size of the manifest. The limit is on data, because each thread reserves much
    // more address space than it uses, and there are as many threads as processors.
    const std::string limit = "ulimit -d 4000000; ";
#endif
    const std::string limited = limit + "exec timeout 60 \"$TWRENCH\" ";
    expect_refused(run_shell(folder, limited + "encode f -o v.mp4"), 5, "manifest.json");
    const Outcome drawn = run_shell(folder, limited + frames_command);
    EXPECT_EQ(drawn.code, 2) << drawn.err;
  }
}

// The user's limit on threads is exhausted.
TEST(Hostile, NoThreadCanBeStarted) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can be a user without other processes";
  const ScratchFolder folder;
  fs::permissions(folder.path(), fs::perms::all);
  const Outcome run = run_shell(
      folder,
      "timeout 60 setpriv --reuid 54321 --regid 54321 --clear-groups prlimit --nproc=12 "
      "\"$TWRENCH\" render --size 64x36 --no-video --progress none --frames-dir f --jobs 64");
  if (run.code == 126 || run.code == 127) GTEST_SKIP() << "another user may not start it here";
  expect_refused(run, 5, "cannot start a thread");
  EXPECT_THAT(run.err, HasSubstr("--jobs"));
}

}  // namespace
}  // namespace twrench
