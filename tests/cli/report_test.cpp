#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "cli/twrench.h"

namespace twrench {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// How often `word` is in the text.
std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(Report, HasThreeExperimentsUnlessASceneIsGiven) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report --static -o a.html").code, 0);
  const std::string all = text_of(folder / "a.html");
  for (const char* heading :
       {"Equations", "The body", "The Dzhanibekov effect", "Stable rotation about y",
        "Stable rotation about z", "The methods", "References"}) {
    EXPECT_EQ(count(all, std::string("<h2>") + heading + "</h2>"), 1U) << heading;
  }
  EXPECT_EQ(count(all, "<svg"), 4U);
  EXPECT_EQ(count(all, "<math "), 4U);
  EXPECT_THAT(all, Not(HasSubstr("<iframe")));
  ASSERT_EQ(run_twrench(folder, "report stable-z --duration 10 --static -o b.html").code, 0);
  const std::string one = text_of(folder / "b.html");
  EXPECT_EQ(count(one, "<svg"), 2U);
  EXPECT_THAT(one, HasSubstr("<h1>Stable rotation about z</h1>"));
}

TEST(Report, HasTheNumbersOfTheOtherCommands) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report dzhanibekov --static -o a.html").code, 0);
  const std::string report = text_of(folder / "a.html");
  EXPECT_THAT(report, HasSubstr("<td>252.58405</td>"));  // mass
  EXPECT_THAT(report, HasSubstr("<td>23.630725</td>"));  // between flips
  EXPECT_THAT(report, HasSubstr("4 predicted, 4 seen in the solution of rkmk45"));
  EXPECT_THAT(report, HasSubstr("<th scope=\"row\">1</th><td>11.815363</td>"));  // flip
  EXPECT_THAT(report, ContainsRegex("rkmk4</th><td>4</td><td>[34]\\.[0-9]+</td>"));
}

// The names in one figure would take the place of those in another.
TEST(Report, HasEachNameOnce) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report --duration 10 --static -o a.html").code, 0);
  const std::string report = text_of(folder / "a.html");
  const std::regex name("\\bid=['\"]([^'\"]*)['\"]");
  std::set<std::string> names;
  for (std::sregex_iterator i(report.begin(), report.end(), name), end; i != end; ++i) {
    EXPECT_TRUE(names.insert((*i)[1]).second) << (*i)[1];
  }
  EXPECT_GT(names.size(), 20U);
  const std::regex used("href=['\"]#([^'\"]*)['\"]");
  for (std::sregex_iterator i(report.begin(), report.end(), used), end; i != end; ++i) {
    EXPECT_TRUE(names.contains((*i)[1])) << (*i)[1];
  }
}

TEST(Report, IsMarkdownWithItsFiguresBesideIt) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report stable-y --duration 10 -o a.md").code, 0);
  const std::string report = text_of(folder / "a.md");
  EXPECT_THAT(report, StartsWith("# Stable rotation about y\n"));
  for (const char* figure : {"a-components-stable-y.svg", "a-methods.svg"}) {
    EXPECT_THAT(report, HasSubstr(std::string("](<") + figure + ">)"));
    EXPECT_THAT(text_of(folder / figure), HasSubstr("</svg>"));
  }
}

// Each command that it names runs.
TEST(Report, NamesCommandsThatRun) {
  const ScratchFolder folder;
  ASSERT_EQ(
      run_twrench(folder, "report --inertia 2,3,4 --omega=-0.1,2,0.1 --duration 5 -o a.md").code,
      0);
  std::istringstream lines(text_of(folder / "a.md"));
  std::set<std::string> commands;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    twrench ")) commands.insert(line.substr(12));
  }
  EXPECT_GE(commands.size(), 10U);
  for (const std::string& command : commands) {
    const Outcome run = run_twrench(folder, command);
    EXPECT_EQ(run.code, 0) << command << "\n" << run.err;
  }
}

TEST(Report, KeepsHostileTextText) {
  const ScratchFolder folder;
  std::ofstream(folder / "s.toml") << "title = '<script>alert(1)</script>|`*[x](y)'\n"
                                      "[body]\nmoments = [1.0, 2.0, 3.0]\n[motion]\n"
                                      "omega = [0.1, 2.0, 0.1]\nduration = 5.0\n";
  ASSERT_EQ(run_twrench(folder, "report s.toml --static -o a.html").code, 0);
  EXPECT_THAT(text_of(folder / "a.html"), Not(HasSubstr("<script>")));
  ASSERT_EQ(run_twrench(folder, "report s.toml -o a.md").code, 0);
  EXPECT_THAT(text_of(folder / "a.md"), HasSubstr("\\<script\\>alert(1)\\</script\\>\\|\\`\\*"));
}

TEST(Report, RefusesWhatItCannotDo) {
  const ScratchFolder folder;
  std::ofstream(folder / "s.toml") << "[body]\nmoments = [1.0, 2.0, 3.0]\n";
  const auto expect_refused = [&](const std::string& options, int code, const char* message) {
    const Outcome run = run_twrench(folder, "report " + options);
    EXPECT_EQ(run.code, code) << options;
    EXPECT_THAT(run.err, StartsWith("twrench: error: "));
    EXPECT_THAT(run.err, HasSubstr(message));
  };
  expect_refused("", 2, "--output");
  expect_refused("-o a.pdf", 2, "its name must end in .html or .md");
  expect_refused("s.toml --static -o s.toml", 2, "s.toml");
  expect_refused("--static -o no/such.html", 5, "No such file or directory");
  expect_refused("--static -o /dev/full", 2, "its name must end in");
  expect_refused("--static --method rk4 --step 9 -o a.html", 2, "longer than a turn");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.html"));
}

}  // namespace
}  // namespace twrench
