// Faults during long runs: each ends with one clear line and the right exit code, all finished
// frames are intact, and nothing incomplete remains.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/held_run.h"
#include "cli/twrench.h"
#include "system/bytes.h"
#include "system/file.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

// 200 frames, which take most of a second.
const std::string bare_film = "render --size 160x90 --fps 10 --speed 6 --duration 120 ";
const std::string fault_film = bare_film + "--progress none --frames-dir f ";
const std::string fault_frames = fault_film + "--no-video ";

/// For a fault that a shell causes midway.
const std::string held_film =
    "--size 160x90 --fps 10 --speed 6 --duration 120 --no-video "
    "--frames-dir f";

/// Checks the message of a failure, and the frames that remain.
void expect_told(const Outcome& run, int code, const std::string& message) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_THAT(run.err, StartsWith("twrench: error: "));
  EXPECT_THAT(run.err, HasSubstr(message));
  EXPECT_LE(std::ranges::count(run.err, '\n'), 2) << run.err;
}

/// Checks that each frame in the manifest matches its file. Returns their number.
std::size_t count_whole_frames(const fs::path& folder) {
  const json manifest = json::parse(text_of(folder / "manifest.json"));
  for (const json& frame : manifest["frames"]) {
    const fs::path file = folder / frame["file"].get<std::string>();
    EXPECT_EQ(system::sha256_hex(system::read_file(file, 1 << 24)),
              frame["sha256"].get<std::string>())
        << file;
  }
  return manifest["frames"].size();
}

std::size_t count_temporaries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::ranges::count_if(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
        return entry.path().filename().string().starts_with(".");
      }));
}

void put_program(const ScratchFolder& folder, const std::string& name, const std::string& script) {
  fs::create_directories(folder / "bin");
  system::write_file_atomically(folder / ("bin/" + name), "#!/bin/sh\n" + script + "\n");
  fs::permissions(folder / ("bin/" + name), fs::perms::owner_all);
}

const std::string with_bin = "PATH=\"$PWD/bin:$PATH\" ";

/// Runs the commands in a file system of limited size mounted at d, and copies its final contents
/// to `after`. If mounting is not permitted, or if root of the namespace may not enter the folder
/// because it lies in the home of another user, the outcome's code is -1. As root of the namespace,
/// Mesa would look for its cache in root's home and complain that it has no access.
Outcome run_on_small_disk(const ScratchFolder& folder, const std::string& size,
                          const std::string& commands) {
  const std::string try_mount = "unshare -rm sh -c 'mount -t tmpfs tmpfs /tmp && cd \"$PWD\"'";
  if (run_shell(folder, try_mount).code != 0) return {};
  return run_shell(folder,
                   "mkdir d && export TWRENCH XDG_CACHE_HOME=\"$PWD/cache\" && unshare -rm sh -c "
                   "'mount -t tmpfs -o size=" +
                       size + " tmpfs d && { " + commands +
                       "; }; code=$?; cp -r d after; exit $code'");
}

TEST(Faults, ADiskTooSmallIsToldBeforeTheFirstFrame) {
  const ScratchFolder folder;
  const Outcome run = run_on_small_disk(
      folder, "500k", "cd d && \"$TWRENCH\" " + fault_frames + "; code=$?; cd ..; (exit $code)");
  if (run.code == -1) GTEST_SKIP() << "no file system can be mounted here";
  expect_told(run, 5, "the run needs an estimated");
  EXPECT_THAT(run.err, HasSubstr("free some space"));
  EXPECT_FALSE(fs::exists(folder / "after/f"));
}

// The estimate cannot foresee this, because another program uses up the space.
TEST(Faults, ADiskThatFillsUpMidway) {
  const ScratchFolder folder;
  const Outcome run =
      run_on_small_disk(folder, "30m",
                        "cd d && " + start_held(held_film) + "cat /dev/zero >big 2>/dev/null; " +
                            release_held + "; code=$?; rm big; cd ..; (exit $code)");
  if (run.code == -1) GTEST_SKIP() << "no file system can be mounted here";
  expect_told(run, 5, "No space left on device");
  count_whole_frames(folder / "after/f");
  EXPECT_TRUE(fs::exists(folder / "after/f/frame_000000.png"));
  EXPECT_EQ(count_temporaries(folder / "after/f"), 0U);
}

// A file size limit simulates a disk that the video fills.
TEST(Faults, AFilmThatOutgrowsItsDisk) {
  const ScratchFolder folder;
  const Outcome run = run_shell(
      folder, "ulimit -f 20; trap '' XFSZ; \"$TWRENCH\" " + fault_film + "--no-frames -o v.mp4");
  EXPECT_THAT(run.code, AnyOf(4, 5)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("v.mp4"));
  EXPECT_FALSE(fs::exists(folder / "v.mp4"));
  EXPECT_EQ(count_temporaries(folder.path()), 0U);
}

// The second figure of a report fills the disk, and gnuplot reports success.
TEST(Faults, AReportWhoseFiguresDoNotFit) {
  const ScratchFolder folder;
  put_program(folder, "gnuplot",
              "case \"$*\" in *-e*) exit 0;; esac\n[ -e drawn ] || echo '<svg></svg>'\n"
              ": >drawn\ncat >/dev/null");
  const Outcome run = run_twrench(folder, "report stable-y --duration 5 -o r.md", with_bin);
  expect_told(run, 5, "cannot write r-methods.svg");
  EXPECT_TRUE(fs::exists(folder / "drawn"));
  EXPECT_FALSE(fs::exists(folder / "r.md"));
  EXPECT_FALSE(fs::exists(folder / "r-components-stable-y.svg"));
  EXPECT_EQ(count_temporaries(folder.path()), 0U);
}

// The first figure fits, the second does not.
TEST(Faults, AReportThatFillsItsDisk) {
  const ScratchFolder folder;
  const Outcome run =
      run_on_small_disk(folder, "240k",
                        "cd d && \"$TWRENCH\" report stable-y --duration 5 -o r.md; "
                        "code=$?; cd ..; (exit $code)");
  if (run.code == -1) GTEST_SKIP() << "no file system can be mounted here";
  expect_told(run, 5, "cannot write r");
  EXPECT_TRUE(fs::is_empty(folder / "after"));
}

TEST(Faults, AManifestThatCannotBeWritten) {
  const ScratchFolder folder;
  const auto start = std::chrono::steady_clock::now();
  const Outcome run =
      run_shell(folder, "ulimit -f 100; trap '' XFSZ; \"$TWRENCH\" " + fault_frames);
  const bool none_was_due = std::chrono::steady_clock::now() - start < std::chrono::seconds(5);
  expect_told(run, 5, "manifest.json");  // the frames are smaller
  EXPECT_EQ(count_temporaries(folder / "f"), 0U);
  // All frames exist. If drawing was so slow that a manifest was due before the end, there are only
  // as many as fit into a manifest of that size.
  EXPECT_TRUE(fs::exists(folder / (none_was_due ? "f/frame_000199.png" : "f/frame_000070.png")));
  count_whole_frames(folder / "f");  // in the previous manifest
}

TEST(Faults, TheFolderIsRemovedMidway) {
  const ScratchFolder folder;
  const Outcome run = run_shell(folder, start_held(held_film) + "mv f g; " + release_held);
  expect_told(run, 5, "No such file or directory");
  EXPECT_EQ(count_temporaries(folder / "g"), 0U);
}

TEST(Faults, TheFolderBecomesReadOnlyMidway) {
  const ScratchFolder folder;
  const Outcome run =
      run_on_small_disk(folder, "400m",
                        "cd d && " + start_held(held_film) +
                            "until mount -o remount,bind,ro \"$PWD\" 2>/dev/null; do sleep 0.01; "
                            "done; " +
                            release_held + "; code=$?; cd ..; (exit $code)");
  if (run.code == -1) GTEST_SKIP() << "no file system can be mounted here";
  expect_told(run, 5, "Read-only file system");
  count_whole_frames(folder / "after/f");
}

TEST(Faults, FfmpegThatFailsAtOnceIsMissedBeforeTheFirstFrame) {
  const std::pair<const char*, const char*> faults[] = {
      {"echo \"Unknown encoder 'libx264'\" >&2; exit 1", "Unknown encoder"},
      {"case \"$*\" in *' -crf '*) echo \"Unrecognized option 'crf'.\" >&2; exit 1; esac",
       "Unrecognized option 'crf'"},
      {"kill -SEGV $$", "exit status 139"}};
  for (const auto& [script, message] : faults) {
    const ScratchFolder folder;
    put_program(folder, "ffmpeg", script);
    expect_told(run_twrench(folder, fault_film, with_bin), 4, message);
    EXPECT_FALSE(fs::exists(folder / "f"));
  }
}

// The loader finds drivers by name, so these files replace them.
TEST(Faults, NoUsableOpenGlLibrary) {
  const ScratchFolder folder;
  fs::create_directories(folder / "lib");
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    system::write_file_atomically(folder / ("lib/" + std::string(name)), "not a library");
  }
  const Outcome run = run_twrench(folder, fault_frames, "LD_LIBRARY_PATH=\"$PWD/lib\" ");
  if (run.code == 0) GTEST_SKIP() << "the library is found elsewhere";
  expect_told(run, 3, "OpenGL");
  EXPECT_THAT(run.err, HasSubstr("apt-get install"));
  EXPECT_FALSE(fs::exists(folder / "f"));
}

TEST(Faults, ADriverThatCrashes) {
  const ScratchFolder folder;
  fs::create_directories(folder / "lib");
  for (const char* name : {"libOSMesa.so.8", "libEGL.so.1"}) {
    fs::copy_file(TWRENCH_CRASHING_DRIVER, folder / ("lib/" + std::string(name)));
  }
  const std::string with_lib = "LD_LIBRARY_PATH=\"$PWD/lib\" ";
  expect_told(run_twrench(folder, fault_frames, with_lib), 3, "its driver crashes");
  EXPECT_FALSE(fs::exists(folder / "f"));
  const Outcome doctor = run_twrench(folder, "doctor", with_lib);
  EXPECT_EQ(doctor.code, 3) << doctor.err;
  EXPECT_THAT(doctor.out, HasSubstr("OpenGL by osmesa"));
  EXPECT_THAT(doctor.out, HasSubstr("its driver crashes"));
  EXPECT_THAT(doctor.out, HasSubstr("ffmpeg version")) << "the rest is examined, too";
}

TEST(Faults, AnOpenGlWithoutACoreProfile) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, fault_frames, "MESA_GL_VERSION_OVERRIDE=2.1 ");
  expect_told(run, 3, "core profile");
}

#if !defined(TWRENCH_SANITIZED)  // they report crashes
TEST(Faults, ACrashIsOneMessage) {
  const ScratchFolder folder;
  const Outcome run = run_shell(folder, start_held(held_film) + "kill -SEGV $pid; wait $pid");
  expect_told(run, 70, "internal: it crashed");
}
#endif

#if !defined(TWRENCH_SANITIZED)  // they reserve all memory
TEST(Faults, TooLittleMemory) {
  const ScratchFolder folder;
  // The picture needs several times as much. The limit is on data, because each thread reserves
  // much more address space than it uses, and there are as many threads as processors.
  const Outcome run = run_shell(
      folder,
      "ulimit -d 1500000; \"$TWRENCH\" render --size 8192x8192 --samples 4 --no-video --frames 0");
  EXPECT_THAT(run.code, AnyOf(3, 70)) << run.err;
  EXPECT_THAT(run.err, StartsWith("twrench: error: "));
  EXPECT_THAT(run.err, HasSubstr("fewer"));
  EXPECT_FALSE(fs::exists(folder / "out/dzhanibekov/frame_000000.png"));
}
#endif

TEST(Faults, NobodyListens) {
  const ScratchFolder folder;
  const std::string shown =
      "\"$TWRENCH\" " + bare_film + "--frames 0-19 --no-video --progress bar --frames-dir f ";
  for (const char* listener :
       {"2>&1 | true", "2>&1 | head -c 10 >/dev/null", ">&- 2>&-", "2>/dev/full"}) {
    run_shell(folder, "{ " + shown + "; echo $? >code; } " + listener);
    EXPECT_EQ(text_of(folder / "code"), "0\n") << listener;
  }
  EXPECT_EQ(count_whole_frames(folder / "f"), 20U);
  run_shell(folder, "{ \"$TWRENCH\" simulate; echo $? >code; } | true");
  EXPECT_EQ(text_of(folder / "code"), "141\n");
}

TEST(Faults, ALocaleWithDecimalCommas) {
  const ScratchFolder folder;
  const std::string numbers = "simulate --times 0.5,1.5";
  EXPECT_EQ(run_twrench(folder, numbers, "LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 ").out,
            run_twrench(folder, numbers).out);
}

TEST(Faults, APathWithSpacesQuotesAndUtf8) {
  const ScratchFolder folder;
  const std::string name = "-it's a \"film\" %d é";
  const std::string quoted = "'-it'\\''s a \"film\" %d é'";
  const Outcome run =
      run_twrench(folder, bare_film + "--frames 0-3 --progress none --frames-dir=" + quoted +
                              " --output=" + quoted + ".mp4");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(count_whole_frames(folder / name), 4U);
  EXPECT_TRUE(fs::exists(folder / (name + ".mp4")));
  EXPECT_EQ(run_twrench(folder, "encode --output=concat:x.mp4 -- " + quoted).code, 0);
  EXPECT_TRUE(fs::exists(folder / "concat:x.mp4"));
}

TEST(Faults, NoHomeToWriteTo) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, fault_frames + "--frames 0-3",
                        "HOME=/proc XDG_CACHE_HOME=/proc TMPDIR=/proc ")
                .code,
            0);
}

// A manifest can only name files in its own folder, and writing does not follow links to other
// files.
TEST(Hostile, AManifestLeadsNowhereElse) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, fault_frames + "--frames 0-1").code, 0);
  const std::string manifest = text_of(folder / "f/manifest.json");
  for (const char* path : {"../secret.png", "/etc/passwd", "..", "a/b.png", ""}) {
    std::string changed = manifest;
    changed.replace(changed.find("frame_000001.png"), 16, path);
    system::write_file_atomically(folder / "f/manifest.json", changed);
    expect_told(run_twrench(folder, "encode f -o v.mp4 --progress none"), 5,
                "a file name without a path");
  }
}

TEST(Hostile, ALinkInAFramesPlaceIsReplacedNotFollowed) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "precious", "untouched");
  fs::create_directory(folder / "f");
  fs::create_symlink("../precious", folder / "f/frame_000000.png");
  ASSERT_EQ(run_twrench(folder, fault_frames + "--frames 0 --overwrite").code, 0);
  EXPECT_EQ(text_of(folder / "precious"), "untouched");
  EXPECT_FALSE(fs::is_symlink(folder / "f/frame_000000.png"));
}

TEST(Doctor, SaysWhatIsThere) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "doctor");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_THAT(run.out, HasSubstr("llvmpipe"));
  EXPECT_THAT(run.out, HasSubstr(" free\n"));
  EXPECT_THAT(run.out, HasSubstr("can run."));
  EXPECT_EQ(folder.names().size(), 2U) << "the outputs of the run alone";
  EXPECT_TRUE(json::parse(run_twrench(folder, "doctor --format json").out)["can_render"]);
  // The columns are aligned.
  std::istringstream lines(run.out);
  std::set<std::size_t> columns;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t found = line.find("  found    "), missing = line.find("  missing  ");
    if (std::min(found, missing) != std::string::npos) columns.insert(std::min(found, missing));
  }
  EXPECT_EQ(columns.size(), 1U);
}

TEST(Doctor, SaysWhatIsMissingAndTheRemedy) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "doctor --format json", "PATH=/nowhere ");
  EXPECT_EQ(run.code, 4);
  const json found = json::parse(run.out);
  EXPECT_FALSE(found["can_render"]);
  EXPECT_THAT(run.out, HasSubstr("apt-get install ffmpeg"));
  EXPECT_EQ(run_twrench(folder, "doctor", "MESA_GL_VERSION_OVERRIDE=2.1 ").code, 3);
}

TEST(Progress, AsOpenJobDescriptionReadsIt) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, bare_film + "--no-video --frames 0-4 --progress openjd");
  EXPECT_THAT(run.out, HasSubstr("openjd_progress: 100.0\nopenjd_status: 5 of 5 frames"));
  const Outcome failed = run_twrench(folder, "encode nowhere -o v.mp4 --progress openjd");
  EXPECT_EQ(failed.code, 5);
  EXPECT_THAT(failed.out, StartsWith("openjd_fail: cannot use nowhere: "));
}

}  // namespace
}  // namespace twrench
