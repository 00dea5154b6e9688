// The program's output: help, messages for users and for programs, and protection against forged
// lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "cli/twrench.h"
#include "system/file.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string tiny = "render --size 64x36 --frames 0-4 --frames-dir f --no-video ";

std::vector<std::string> lines_of_output(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Help, OfACommandIsWhatItsOptionPrints) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "help").out, run_twrench(folder, "--help").out);
  for (const char* command : {"render", "simulate", "compare", "doctor", "help"}) {
    const Outcome run = run_twrench(folder, std::string("help ") + command);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, run_twrench(folder, std::string(command) + " --help").out);
  }
}

TEST(Help, ListsDefaultsAndExitCodes) {
  const ScratchFolder folder;
  EXPECT_THAT(run_twrench(folder, "--help").out, HasSubstr("\n  5         a file could not be"));
  const std::string render = run_twrench(folder, "render --help-all").out;
  for (const char* part : {"[SCENE]\n", "(default: dzhanibekov)", "(default: 1920x1080)",
                           "(default: 1,0.05,0)", "(default: studio)", "  --timing  "}) {
    EXPECT_THAT(render, HasSubstr(part));
  }
  for (const char* command :
       {"render", "plot", "simulate", "export", "study", "encode", "compare"}) {
    for (const char* option : {" --help", " --help-all"}) {
      const std::string text = run_twrench(folder, command + std::string(option)).out;
      for (const char* jargon : {"TEXT:", "{", "(1x)", "REQUIRED"}) {
        EXPECT_THAT(text, Not(HasSubstr(jargon))) << command;
      }
    }
  }
  EXPECT_THAT(run_twrench(folder, "compare --help").out, HasSubstr("0 alike, 1 different"));
  EXPECT_THAT(run_twrench(folder, "plot --help").out, HasSubstr("[SCENE...]\n"));
}

// Users search the help for these words.
TEST(Help, OfRenderNamesWhatAFilmCanBe) {
  const ScratchFolder folder;
  const std::string help = run_twrench(folder, "render --help-all").out;
  for (const char* line :
       {"--output [^\n]*GIF", "--speed [^\n]*slow motion", "--output [^\n]*slides",
        "--background [^\n]*transparent for overlays[^\n]*webm",
        "--language [^\n]*language of the words [^\n]*: en or nb"}) {
    EXPECT_THAT(help, testing::ContainsRegex(line));
  }
}

// The short help contains these words and fits on one screen.
TEST(Help, OfRenderHasTheWordsThatUsersSearchFor) {
  const ScratchFolder folder;
  const std::string help = run_twrench(folder, "render --help").out;
  for (const char* word : {"slow motion", "transparent", "GIF", "caption", "--help-all"}) {
    EXPECT_THAT(help, HasSubstr(word));
  }
  EXPECT_LE(std::ranges::count(help, '\n'), 50) << help;
  EXPECT_THAT(help, HasSubstr("\nMost used options:\n  -o,--output VIDEO "));
  EXPECT_THAT(help, testing::ContainsRegex("\n  Camera  +--azimuth --elevation "));
}

/// The names of the options at the beginning of the lines of help: "--size".
std::multiset<std::string> described_options(const std::string& help) {
  static const std::regex line("\n  (-[a-z],)?(--[a-z-]+)");
  std::multiset<std::string> names;
  for (std::sregex_iterator match(help.begin(), help.end(), line), end; match != end; ++match) {
    names.insert((*match)[2]);
  }
  return names;
}

TEST(Help, OfALongCommandDescribesTenOptionsAndNamesTheOthers) {
  const ScratchFolder folder;
  for (const std::string command :
       {"render", "export", "page", "plot", "report", "study", "check", "simulate"}) {
    const std::string help = run_twrench(folder, command + " --help").out;
    const Outcome all = run_twrench(folder, command + " --help-all");
    EXPECT_EQ(all.code, 0) << all.err;
    EXPECT_EQ(described_options(help).size(), 10U) << command;
    const std::multiset<std::string> options = described_options(all.out);
    EXPECT_GT(options.size(), 20U) << command;
    for (const std::string& option : options) {
      EXPECT_EQ(options.count(option), 1U) << command << " " << option;
      EXPECT_THAT(help, testing::ContainsRegex("[ ,]" + option + "[ \n]")) << command;
    }
    EXPECT_THAT(all.out, HasSubstr("\nRun:\n  -h,--help "));
  }
}

TEST(Help, OfAShortCommandDescribesEachOption) {
  const ScratchFolder folder;
  for (const std::string command : {"encode", "compare", "schema"}) {
    const std::string help = run_twrench(folder, command + " --help").out;
    EXPECT_THAT(help, Not(HasSubstr("Most used"))) << command;
    EXPECT_THAT(help, HasSubstr("\nOptions:\n")) << command;
  }
}

TEST(Help, AFullDiskIsAnError) {
  const ScratchFolder folder;
  for (const char* words : {"--help", "--version", "help", "render --help"}) {
    const Outcome run = run_shell(folder, std::string("\"$TWRENCH\" ") + words + " >/dev/full");
    EXPECT_EQ(run.code, 5) << words;
    EXPECT_EQ(run.err,
              "twrench: error: cannot write standard output: No space left on device\n"
              "  free some space there, or choose another disk\n");
  }
}

TEST(Words, AnEmptyTitleIsOne) {
  const ScratchFolder folder;
  for (const char* title : {"--title ''", "--title="}) {
    EXPECT_EQ(run_twrench(folder, tiny + "--overwrite " + title).code, 0) << title;
    EXPECT_EQ(json::parse(text_of(folder / "f/manifest.json"))["scene"]["title"], "");
  }
}

TEST(Words, AllIsJsonWhereJsonIsAskedFor) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, tiny + "--progress json --inertia 1,1,3 --timing");
  EXPECT_EQ(run.code, 0);
  const std::vector<std::string> lines = lines_of_output(run.err);
  ASSERT_GE(lines.size(), 4U) << run.err;
  for (const std::string& line : lines) EXPECT_TRUE(json::accept(line)) << line;
  EXPECT_THAT(json::parse(lines.front())["warning"].get<std::string>(), HasSubstr("no real body"));
  const json summary = json::parse(lines[lines.size() - 2]);
  EXPECT_EQ(summary["frames"], 5);
  EXPECT_EQ(summary["frames_folder"], "f");
  EXPECT_TRUE(json::parse(lines.back()).contains("cpu_ms_per_frame"));
}

TEST(Words, BytesThatAreNoUtf8AreReplacedInJson) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "b\xff.toml", "[body]\nmoments = [1, 2, 3]\n");
  for (const char* command : {"simulate --times 1 --format json", "inertia --format json",
                              "study --methods exact --duration 1 --format json"}) {
    const Outcome run = run_twrench(folder, std::string(command) + " b\xff.toml");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["scene"], "b\ufffd") << command;
  }
  const std::string titled = tiny + "--title 'a\xff' ";
  EXPECT_EQ(run_twrench(folder, titled).code, 0);
  EXPECT_EQ(run_twrench(folder, titled + "--resume").code, 0) << "the same film";
}

TEST(Words, NothingForgesLinesOfOpenjd) {
  const ScratchFolder folder;
  const Outcome run =
      run_shell(folder,
                "\"$TWRENCH\" encode \"$(printf 'a\\nopenjd_env: PATH=/b')\" -o v.mp4 "
                "--progress openjd");
  EXPECT_EQ(run.code, 5);
  EXPECT_EQ(lines_of_output(run.out).size(), 1U) << run.out;
  EXPECT_THAT(run.out, StartsWith("openjd_fail: cannot use a\\nopenjd_env: PATH=/b: "));
}

TEST(Words, TablesAreEscapedToo) {
  const ScratchFolder folder;
  const std::string name = "a\x1b[2J.toml";
  system::write_file_atomically(folder / name, "[body]\nmoments = [1, 2, 3]\n");
  for (const char* command : {"inertia ", "study --methods exact --duration 1 "}) {
    const Outcome run = run_twrench(folder, command + ("'" + name + "'"));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("a\\x1b[2J"));
    EXPECT_THAT(run.out, Not(HasSubstr("\x1b")));
  }
}

/// Runs the program on a terminal and returns the terminal's output.
std::string seen_on_terminal(const ScratchFolder& folder, const std::string& environment) {
  return run_shell(folder,
                   environment + " script -qec '\"$TWRENCH\" " + tiny + "--overwrite' /dev/null")
      .out;
}

TEST(Words, ATerminalGetsNoBytesThatAreNoText) {
  const ScratchFolder folder;
  if (run_shell(folder, "script -qec true /dev/null").code != 0) GTEST_SKIP() << "no script";
  for (const std::string command : {"simulate --format npz", "export --format glb -o -"}) {
    const std::string shown =
        run_shell(folder, "script -qec '\"$TWRENCH\" " + command + "' /dev/null").out;
    EXPECT_THAT(shown, HasSubstr("standard output is a terminal"));
    EXPECT_THAT(shown, HasSubstr("redirect it to a file or a program"));
  }
}

TEST(Words, ATerminalGetsABarThatFits) {
  const ScratchFolder folder;
  if (run_shell(folder, "script -qec true /dev/null").code != 0) GTEST_SKIP() << "no script";
  const std::string shown = seen_on_terminal(folder, "TERM=xterm COLUMNS=30");
  EXPECT_THAT(shown, HasSubstr("\r"));
  EXPECT_THAT(shown, HasSubstr("5/5  "));
  EXPECT_THAT(shown, Not(HasSubstr("\x1b")));
  EXPECT_THAT(seen_on_terminal(folder, "TERM=xterm COLUMNS=80"), HasSubstr("[##"));
  const std::string plain = seen_on_terminal(folder, "TERM=dumb");
  EXPECT_THAT(plain, HasSubstr("5 of 5 frames"));
  EXPECT_THAT(plain, Not(HasSubstr("[##")));
}

TEST(Words, ABarInAFileHasNoEscapes) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, tiny + "--progress bar", "TERM=xterm ");
  EXPECT_THAT(run.err, HasSubstr("] 5/5 "));
  EXPECT_THAT(run.err, Not(HasSubstr("\x1b")));
}

// exec keeps the times already counted for the process and its children.
TEST(Words, TimingDoesNotCountTheTimeBefore) {
  const ScratchFolder folder;
  const Outcome run =
      run_shell(folder, "sh -c 'head -c 60000000 /dev/zero | sha256sum; exec \"$TWRENCH\" " + tiny +
                            "--progress none --timing=json'");
  EXPECT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.err);
  EXPECT_EQ(report["cpu_ms_per_frame"]["children"], 0.0);
}

/// Runs the command as the user nobody, because root has every permission.
Outcome run_as_nobody(const ScratchFolder& folder, const std::string& command) {
  return run_shell(folder,
                   "setpriv --reuid 65534 --regid 65534 --clear-groups sh -c '" + command + "'");
}

TEST(Words, ReportAMissingPermission) {
  const ScratchFolder folder;
  if (::geteuid() != 0) GTEST_SKIP() << "only root can be nobody";
  std::filesystem::create_directories(folder / "closed/f");
  std::filesystem::permissions(folder / "closed", std::filesystem::perms::none);
  if (run_as_nobody(folder, "test -x \"$TWRENCH\"").code != 0) GTEST_SKIP() << "nobody sees it";
  for (const char* words : {"encode closed/f -o v.mp4", "inertia closed/a.toml", "inertia closed/a",
                            "simulate -o closed/a.csv", "compare closed/a.png closed/a.png",
                            "render --size 32x32 --frames 0 --no-video --frames-dir closed/f"}) {
    const Outcome run = run_as_nobody(folder, std::string("\"$TWRENCH\" ") + words);
    EXPECT_EQ(run.code, 5) << words << "\n" << run.err;
    EXPECT_THAT(run.err, HasSubstr("Permission denied")) << words;
  }
  std::filesystem::permissions(folder / "closed", std::filesystem::perms::owner_all);
}

TEST(Doctor, ReportsWhereNothingCanBeWritten) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "out", "no folder");
  const Outcome run = run_twrench(folder, "doctor --format json");
  EXPECT_FALSE(json::parse(run.out)["can_render"].get<bool>());
  EXPECT_THAT(run.out, HasSubstr("Not a directory"));
  EXPECT_EQ(run.code, 5);
}

}  // namespace
}  // namespace twrench
