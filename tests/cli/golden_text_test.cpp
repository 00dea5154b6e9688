// Whole outputs of the program, compared with texts that were read and found correct. A file of
// tests/golden/text is a transcript: lines that begin with "$ " are commands, which run one after
// another in an empty folder, and the lines below a command are its output, then its messages, then
// its exit code unless that is 0. Numbers are compared as numbers, so that the last digits may
// depend on the compiler. To renew the texts, run TWRENCH_UPDATE_GOLDENS=1 cli_test, read the
// difference, and commit it with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/twrench.h"
#include "sanitizers.h"

namespace twrench {
namespace {

namespace fs = std::filesystem;

fs::path text_folder() { return TWRENCH_TESTS_DIR "/golden/text"; }

struct Step {
  std::string command;
  std::string printed;
};

std::vector<Step> steps_of(const std::string& transcript) {
  std::vector<Step> steps;
  std::istringstream lines(transcript);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("$ ")) {
      steps.push_back({line.substr(2), ""});
    } else if (!steps.empty()) {
      steps.back().printed += line + "\n";
    }
  }
  return steps;
}

/// Returns the output of a command, without the name of the folder in which it ran.
std::string printed_by(const ScratchFolder& folder, const std::string& command) {
  const Outcome run = run_shell(folder, "twrench() { \"$TWRENCH\" \"$@\"; }; " + command);
  std::string text = run.out + run.err;
  if (run.code != 0) text += "exit code " + std::to_string(run.code) + "\n";
  const std::string path = folder.path().string();
  for (std::size_t at = 0; (at = text.find(path, at)) != std::string::npos;) {
    text.replace(at, path.size(), "FOLDER");
  }
  return text;
}

bool are_near(const std::string& expected, const std::string& actual) {
  const double one = std::strtod(expected.c_str(), nullptr);
  const double other = std::strtod(actual.c_str(), nullptr);
  constexpr double relative = 1e-6, rounding_errors = 1e-9;
  return std::abs(one - other) <= rounding_errors + relative * std::abs(one);
}

/// A line, split into numbers and the text around them.
struct Line {
  std::vector<std::string> words;  ///< One more than the numbers.
  std::vector<std::string> numbers;
};

Line parse(const std::string& line) {
  static const std::regex number(R"([-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)");
  Line parsed;
  std::sregex_iterator match(line.begin(), line.end(), number), end;
  std::string rest = line;
  for (; match != end; ++match) {
    parsed.words.push_back(match->prefix());
    parsed.numbers.push_back(match->str());
    rest = match->suffix();
  }
  parsed.words.push_back(rest);
  return parsed;
}

std::string without_spaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// Returns whether two lines are equal, except for rounding errors in numbers and, if numbers
/// differ in length, the spaces beside them.
bool are_alike(const std::string& expected, const std::string& actual) {
  if (expected == actual) return true;
  const Line one = parse(expected), other = parse(actual);
  if (one.numbers.size() != other.numbers.size()) return false;
  bool same_lengths = true;
  for (std::size_t i = 0; i < one.numbers.size(); ++i) {
    if (!are_near(one.numbers[i], other.numbers[i])) return false;
    same_lengths &= one.numbers[i].size() == other.numbers[i].size();
  }
  for (std::size_t i = 0; i < one.words.size(); ++i) {
    const bool equal = same_lengths
                           ? one.words[i] == other.words[i]
                           : without_spaces(one.words[i]) == without_spaces(other.words[i]);
    if (!equal) return false;
  }
  return true;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The first line that differs, or nothing.
std::string difference(const std::string& expected, const std::string& actual) {
  const std::vector<std::string> one = lines_of(expected), other = lines_of(actual);
  for (std::size_t i = 0; i < std::max(one.size(), other.size()); ++i) {
    const std::string wanted = i < one.size() ? one[i] : "(nothing)";
    const std::string found = i < other.size() ? other[i] : "(nothing)";
    if (!are_alike(wanted, found)) return "expected: " + wanted + "\n   found: " + found;
  }
  return "";
}

class GoldenText : public testing::TestWithParam<const char*> {};

TEST_P(GoldenText, IsPrinted) {
  if (has_sanitizers && std::string(GetParam()) == "report") {
    GTEST_SKIP() << "computes numbers that the other transcripts have";
  }
  const fs::path file = text_folder() / (std::string(GetParam()) + ".txt");
  const std::vector<Step> steps = steps_of(text_of(file));
  ASSERT_FALSE(steps.empty()) << file;
  const bool renew = std::getenv("TWRENCH_UPDATE_GOLDENS") != nullptr;
  const ScratchFolder folder;
  std::string renewed;
  for (const Step& step : steps) {
    const std::string printed = printed_by(folder, step.command);
    renewed += "$ " + step.command + "\n" + printed;
    if (renew) continue;
    EXPECT_EQ(difference(step.printed, printed), "") << "$ " << step.command;
  }
  if (renew) std::ofstream(file) << renewed;
}

INSTANTIATE_TEST_SUITE_P(Commands, GoldenText,
                         testing::Values("cases", "check", "compare", "export", "help", "inertia",
                                         "plot", "render", "report", "scenes", "simulate", "study"),
                         [](const auto& file) { return std::string(file.param); });

TEST(GoldenTexts, AreAllCompared) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(text_folder())) {
    ++files;
    EXPECT_EQ(entry.path().extension(), ".txt");
  }
  EXPECT_EQ(files, 12U);
}

TEST(GoldenTexts, NoticeMoreThanRoundingErrors) {
  EXPECT_TRUE(are_alike("drift  1.2e-16 of 3.5", "drift -7.31e-15 of 3.5000001"));
  EXPECT_FALSE(are_alike("at 3.5 s", "at 3.6 s"));
  EXPECT_FALSE(are_alike("at 3.5 s", "at 3.5 ms"));
  EXPECT_FALSE(are_alike("  3.5", " 3.5"));
  EXPECT_FALSE(are_alike("1, 2", "1, 2, 3"));
}

}  // namespace
}  // namespace twrench
