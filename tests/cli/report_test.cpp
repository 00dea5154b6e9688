#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>

#include "cli/twrench.h"
#include "sanitizers.h"

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

class Report : public testing::Test {
 protected:
  void SetUp() override {
    if (has_sanitizers) GTEST_SKIP() << "computes numbers that the transcripts have";
  }
};

TEST_F(Report, SolvesEveryTaskUnlessASceneIsGiven) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report --static -o a.html").code, 0);
  const std::string all = text_of(folder / "a.html");
  for (const char* heading :
       {"Introduction", "Theory and methods", "Task 1: the functions",
        "Task 2: the sphere, exactly", "Task 3: the Lie-Euler method", "Task 4: RK4 and RKF45",
        "Task 5: the T-wrench", "Task 6: the nine components of X", "All methods", "Discussion",
        "References"}) {
    EXPECT_EQ(count(all, std::string("<h2>") + heading + "</h2>"), 1U) << heading;
  }
  for (const char* heading :
       {"(a) The exponential", "(b) The energy", "(c) The inertia", "RKF45"}) {
    EXPECT_EQ(count(all, std::string("<h3>") + heading), 1U) << heading;
  }
  EXPECT_EQ(count(all, "<h3>(b) Stable rotation about y: ω(0) = (0, 1, 0.05) rad/s</h3>"), 2U);
  EXPECT_EQ(count(all, "<svg"), 4U);
  EXPECT_EQ(count(all, "<math "), 15U);
  EXPECT_THAT(all, Not(HasSubstr("<iframe")));
  EXPECT_THAT(all, ContainsRegex("@page [^\n]*counter\\(page\\)"));  // browsers number the pages
}

TEST_F(Report, HasThePageOfTheMotionInAFrame) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "report stable-z --duration 10 --language nb -o a.html");
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string all = text_of(folder / "a.html");
  if (!run.err.empty()) {  // a program that was built before its page
    EXPECT_EQ(run.err,
              "twrench: note: this build does not include the page, so the report is static; run "
              "scripts/maintain/page.sh, which adds it\n");
    EXPECT_THAT(all, Not(HasSubstr("<iframe")));
    return;
  }
  EXPECT_EQ(count(all, "<iframe"), 1U);
  EXPECT_THAT(all, HasSubstr("<iframe title=\"Bevegelsen\""));
  EXPECT_THAT(all, HasSubstr("srcdoc=\"&lt;!doctype html&gt;"));
  EXPECT_THAT(all, HasSubstr("&quot;language&quot;:&quot;nb&quot;"));
}

TEST_F(Report, OfASceneIsAboutItsMotion) {
  const ScratchFolder folder;
  for (const char* options : {"stable-z", "--inertia 2,3,4", "--omega 1,2,3"}) {
    ASSERT_EQ(
        run_twrench(folder, std::string("report --duration 10 --static -o b.html ") + options).code,
        0);
    const std::string one = text_of(folder / "b.html");
    EXPECT_THAT(one, Not(HasSubstr("Task 1"))) << options;
    for (const char* heading : {"Introduction", "Theory and methods", "The body", "All methods",
                                "Discussion", "References"}) {
      EXPECT_EQ(count(one, std::string("<h2>") + heading + "</h2>"), 1U) << heading;
    }
  }
  ASSERT_EQ(run_twrench(folder, "report stable-z --duration 10 --static -o b.html").code, 0);
  const std::string one = text_of(folder / "b.html");
  EXPECT_EQ(count(one, "<svg"), 2U);
  EXPECT_THAT(one, HasSubstr("<h1>Stable rotation about z</h1>"));
}

TEST_F(Report, HasARowForEachPrincipalAxis) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report --inertia 2,3,4 --duration 10 --static -o b.md").code, 0);
  const std::string text = text_of(folder / "b.md");
  for (const char* row :
       {"| x | 2 | (1, 0, 0) |", "| y | 3 | (0, 1, 0) |", "| z | 4 | (0, 0, 1) |"}) {
    EXPECT_EQ(count(text, row), 1U) << row;
  }
}

TEST_F(Report, HasTheNumbersOfTheOtherCommands) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report dzhanibekov --static -o a.html").code, 0);
  const std::string report = text_of(folder / "a.html");
  EXPECT_THAT(report, HasSubstr("<td>252.58405</td>"));  // mass
  EXPECT_THAT(report, HasSubstr("<td>23.630725</td>"));  // between flips
  EXPECT_THAT(report, HasSubstr("4 predicted, 4 seen in the solution of rkmk45"));
  EXPECT_THAT(report, HasSubstr("1</th><td>11.815363</td><td>11.815363</td>"));  // flip
  EXPECT_THAT(report, ContainsRegex("rkmk4</th>.*<td>4</td><td>[34]\\.[0-9]+</td>"));
}

// Names in one figure would replace the same names in another.
TEST_F(Report, HasEachNameOnce) {
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

TEST_F(Report, IsMarkdownWithItsFiguresBesideIt) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report stable-y --duration 10 -o a.md").code, 0);
  const std::string report = text_of(folder / "a.md");
  EXPECT_THAT(report, StartsWith("# Stable rotation about y\n"));
  for (const char* figure : {"a-components-stable-y.svg", "a-methods.svg"}) {
    EXPECT_THAT(report, HasSubstr(std::string("](") + figure + ")"));
    EXPECT_THAT(text_of(folder / figure), HasSubstr("</svg>"));
  }
}

// Scenes with the same name do not share a figure, and no character of a name ends a link early.
TEST_F(Report, GivesEachFigureAFileOfItsOwn) {
  const ScratchFolder folder;
  const std::string scene = "[body]\nmoments = [1.0, 2.0, 3.0]\n[motion]\nduration = 5.0\n";
  for (const char* name : {"x", "y"}) {
    std::filesystem::create_directory(folder / name);
    std::ofstream(folder / (std::string(name) + "/a) b.toml")) << "title = '" << name << "'\n"
                                                               << scene;
  }
  ASSERT_EQ(run_twrench(folder, "report 'x/a) b.toml' 'y/a) b.toml' -o r.md").code, 0);
  const std::string report = text_of(folder / "r.md");
  EXPECT_THAT(report, HasSubstr("](r-components-a%29%20b.svg)"));
  EXPECT_THAT(report, HasSubstr("](r-components-a%29%20b-2.svg)"));
  EXPECT_THAT(text_of(folder / "r-components-a) b.svg"), HasSubstr(">x<"));
  EXPECT_THAT(text_of(folder / "r-components-a) b-2.svg"), HasSubstr(">y<"));
}

/// The commands that a report in Markdown names.
std::set<std::string> commands_in(const std::string& report) {
  std::istringstream lines(report);
  std::set<std::string> commands;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    twrench ")) commands.insert(line.substr(12));
  }
  return commands;
}

void expect_all_run(const ScratchFolder& folder, const std::set<std::string>& commands) {
  for (const std::string& command : commands) {
    const Outcome run = run_twrench(folder, command);
    EXPECT_EQ(run.code, 0) << command << "\n" << run.err;
  }
}

TEST_F(Report, NamesCommandsThatRun) {
  const ScratchFolder folder;
  ASSERT_EQ(
      run_twrench(folder, "report --inertia 2,3,4 --omega=-0.1,2,0.1 --duration 2 -o a.md").code,
      0);
  const std::set<std::string> commands = commands_in(text_of(folder / "a.md"));
  EXPECT_GE(commands.size(), 10U);
  expect_all_run(folder, commands);
}

TEST_F(Report, OfTheTasksNamesCommandsThatRun) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report --duration 3 -o a.md").code, 0);
  const std::set<std::string> commands = commands_in(text_of(folder / "a.md"));
  EXPECT_GE(commands.size(), 25U);
  expect_all_run(folder, commands);
}

// A name that looks like an option, and one that a shell would split.
TEST_F(Report, NamesCommandsThatRunForAnyName) {
  const ScratchFolder folder;
  for (const char* name : {"--help", "$(touch 'x') y.toml"}) {
    std::ofstream(folder / name) << "[body]\nmoments = [1.0, 2.0, 3.0]\n[motion]\nduration = 2.0\n";
  }
  for (const char* name : {"--help", "'$(touch '\\''x'\\'') y.toml'"}) {
    const Outcome run = run_twrench(folder, std::string("report --output=-a.md -- ") + name);
    ASSERT_EQ(run.code, 0) << run.err;
    const std::set<std::string> commands = commands_in(text_of(folder / "-a.md"));
    EXPECT_THAT(commands, testing::Contains(StartsWith("plot ")));
    EXPECT_THAT(commands, Not(testing::Contains(HasSubstr(" --help"))));
    expect_all_run(folder, commands);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "x"));
}

TEST_F(Report, CitesEveryReferenceInItsOrder) {
  const ScratchFolder folder;
  for (const char* scene : {"", "stable-y ", "dzhanibekov sphere "}) {
    ASSERT_EQ(run_twrench(folder, std::string("report --duration 5 -o a.md ") + scene).code, 0);
    const std::string report = text_of(folder / "a.md");
    const std::size_t list = report.find("## References\n");
    ASSERT_NE(list, std::string::npos);
    const std::regex item("(?:^|\n)([0-9]+)\\. "), citation("\\\\\\[([0-9]+)\\\\\\]");
    const std::string text = report.substr(0, list), references = report.substr(list);
    std::set<int> listed, cited;
    for (std::sregex_iterator i(references.begin(), references.end(), item), end; i != end; ++i) {
      listed.insert(std::stoi((*i)[1]));
    }
    for (std::sregex_iterator i(text.begin(), text.end(), citation), end; i != end; ++i) {
      const int number = std::stoi((*i)[1]);
      EXPECT_LE(number, static_cast<int>(cited.size()) + 1) << "cited before its predecessor";
      cited.insert(number);
    }
    EXPECT_GE(listed.size(), 13U);
    EXPECT_EQ(cited, listed) << scene;
  }
}

TEST_F(Report, HasAFormulaForEverySymbol) {
  const ScratchFolder folder;
  for (const char* scene : {"", "stable-y"}) {
    ASSERT_EQ(run_twrench(folder, std::string("report --duration 5 -o a.md ") + scene).code, 0);
    const std::string report = text_of(folder / "a.md");
    for (const char* symbol : {"L = X",
                               "T =",
                               R"(\dot X =)",
                               R"(\omega =)",
                               R"(\Omega =)",
                               R"(\exp(h \Omega) =)",
                               R"(W' = W \exp(h \Omega))",
                               "s_1 &=",
                               "s_4 &=",
                               "s_k &=",
                               "E =",
                               R"(\dot u =)",
                               "D_i =",
                               "G =",
                               R"(\lambda =)",
                               "1 - m =",
                               "A =",
                               "t_n =",
                               "t_1 =",
                               "K(m) =",
                               R"(F(\varphi, m) =)",
                               R"(\sin \varphi =)",
                               R"(\sin \frac{\theta_s}{2} =)",
                               "e_X =",
                               "e_T =",
                               "e_{SO(3)} =",
                               "e_L ="}) {
      EXPECT_THAT(report, HasSubstr(symbol)) << scene;
    }
  }
}

TEST_F(Report, KeepsHostileTextText) {
  const ScratchFolder folder;
  std::ofstream(folder / "s.toml") << "title = '<script>alert(1)</script>|`*[x](y)'\n"
                                      "[body]\nmoments = [1.0, 2.0, 3.0]\n[motion]\n"
                                      "omega = [0.1, 2.0, 0.1]\nduration = 5.0\n";
  ASSERT_EQ(run_twrench(folder, "report s.toml --static -o a.html").code, 0);
  EXPECT_THAT(text_of(folder / "a.html"), Not(HasSubstr("<script>")));
  ASSERT_EQ(run_twrench(folder, "report s.toml -o a.md").code, 0);
  EXPECT_THAT(text_of(folder / "a.md"), HasSubstr("\\<script\\>alert(1)\\</script\\>\\|\\`\\*"));
}

TEST_F(Report, ShowsAuthorAndDateAsText) {
  const ScratchFolder folder;
  const std::string given = R"( --author '<script>alert(1)</script> & "A" $x$ ![i](j)')"
                            R"( --date '</h1>`*8 November*`' )";
  ASSERT_EQ(run_twrench(folder, "report stable-y --duration 5 --static -o a.html" + given).code, 0);
  const std::string html = text_of(folder / "a.html");
  EXPECT_EQ(count(html, "<script>"), 0U);
  EXPECT_THAT(html, HasSubstr("<p class=\"byline\">&lt;script&gt;alert(1)&lt;/script&gt; &amp; "
                              "&quot;A&quot; $x$ ![i](j)</p>\n"
                              "<p class=\"byline\">&lt;/h1&gt;`*8 November*`</p>"));
  ASSERT_EQ(run_twrench(folder, "report stable-y --duration 5 -o a.md" + given).code, 0);
  EXPECT_THAT(text_of(folder / "a.md"),
              HasSubstr("\nAuthor: \\<script\\>alert(1)\\</script\\> \\& \"A\" \\$x\\$ "
                        "!\\[i\\](j)\n\nDate: \\</h1\\>\\`\\*8 November\\*\\`\n"));
}

TEST_F(Report, IsInNorwegian) {
  const ScratchFolder folder;
  const std::string given = "report stable-y --duration 5 --author A --language no --static -o ";
  const Outcome run = run_twrench(folder, given + "a.html");
  ASSERT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  const std::string html = text_of(folder / "a.html");
  for (const char* part : {"<html lang=\"nb\">", "<h2>Innledning</h2>", "<b>Tabell 1.</b>",
                           "<b>Figur 1.</b>", "<h2>Referanser</h2>", ">steg h (s)<"}) {
    EXPECT_EQ(count(html, part), 1U) << part;
  }
  EXPECT_THAT(html, HasSubstr("--language no --author A --static -o a.html</code>"));
  ASSERT_EQ(run_twrench(folder, given + "a.md").code, 0);
  const std::string markdown = text_of(folder / "a.md");
  for (const char* part : {"\nForfatter: A\n", "**Tabell 1.** ", "**Figur 1.** "}) {
    EXPECT_EQ(count(markdown, part), 1U) << part;
  }
}

TEST_F(Report, IsInTheLanguageOfItsFirstScene) {
  const ScratchFolder folder;
  const char* const body = "[body]\nmoments = [1.0, 2.0, 3.0]\n[motion]\nduration = 2.0\n";
  std::ofstream(folder / "nb.toml") << "language = 'nb'\n" << body;
  std::ofstream(folder / "en.toml") << body;
  ASSERT_EQ(run_twrench(folder, "report nb.toml en.toml -o a.md").code, 0);
  const std::string norwegian = text_of(folder / "a.md");
  EXPECT_THAT(norwegian, StartsWith("# Bevegelsen til et fritt stivt legeme\n"));
  EXPECT_EQ(count(norwegian, "Konstantene for bevegelsen"), 2U);
  ASSERT_EQ(run_twrench(folder, "report nb.toml --language en -o b.md").code, 0);
  EXPECT_THAT(text_of(folder / "b.md"), HasSubstr("## Introduction\n"));
  ASSERT_EQ(run_twrench(folder, "report --inertia 1,2,3 --duration 2 --language nb -o c.md").code,
            0);
  EXPECT_THAT(text_of(folder / "c.md"), StartsWith("# Et fritt stivt legeme"));
}

TEST_F(Report, TellsOfLanguagesThatItLacks) {
  const ScratchFolder folder;
  const Outcome other = run_twrench(folder, "report sphere --duration 2 --language sv -o a.md");
  EXPECT_EQ(other.code, 0);
  EXPECT_EQ(other.err, "twrench: note: the report is in English, not in 'sv'\n");
  EXPECT_THAT(text_of(folder / "a.md"), HasSubstr("## Introduction\n"));
  const Outcome wrong = run_twrench(folder, "report sphere --language norsk -o b.md");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("use en or nb or, for captions in another language, a tag of "
                                   "BCP 47"));
}

// Other programs reject a whole file if any part of it is not UTF-8.
TEST_F(Report, StaysUtf8WithALineEach) {
  const ScratchFolder folder;
  const std::string given =
      "--author \"$(printf 'A\\351\\nB')\" --date \"$(printf '1\\342\\200\\2562')\"";
  ASSERT_EQ(run_twrench(folder, "report sphere --duration 5 -o a.md " + given).code, 0);
  const std::string report = text_of(folder / "a.md");
  EXPECT_THAT(report, HasSubstr("Author: A\\\\xe9\\\\nB\n\nDate: 1\\\\u202e2\n"));
  EXPECT_EQ(count(report, "\xe9"), 0U);
  EXPECT_EQ(run_twrench(folder, "report sphere --duration 5 --author '' -o b.md").code, 2);
}

TEST_F(Report, HasNoDateOfItsOwn) {
  const ScratchFolder folder;
  const std::string report =
      "report sphere --duration 5 --method exact -o - --static | "
      "sed 's/<td>[0-9.]*<\\/td><\\/tr>$//; /<svg/,/<\\/svg>/d'";
  const Outcome now = run_shell(folder, "\"$TWRENCH\" " + report);
  EXPECT_EQ(count(now.out, "byline\">"), 0U);
  EXPECT_EQ(now.out, run_shell(folder, "TZ=Asia/Tokyo \"$TWRENCH\" " + report).out);
}

TEST_F(Report, NeedsNoFolderForTemporaryFiles) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "report stable-y --duration 5 --static -o a.html",
                                  "TMPDIR=/nonexistent ");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(Report, WarnsOfMomentsOnce) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "report --inertia 3,5,9 --duration 5 --static -o a.html");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(count(run.err, "no real body has them"), 1U) << run.err;
  EXPECT_THAT(run.err, HasSubstr("--inertia"));
}

TEST_F(Report, RefusesWhatItCannotDo) {
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
  expect_refused("--duration 5 --static -o no/such.html", 5, "No such file or directory");
  expect_refused("--static -o /dev/full", 2, "its name must end in");
  expect_refused("--static --method rk4 --step 9 -o a.html", 2, "longer than a turn");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.html"));
}

TEST_F(Report, OfBodiesWithAWheelOrAnEnergyLoss) {
  const ScratchFolder folder;
  ASSERT_EQ(run_twrench(folder, "report t-handle --wheel 500,30,0 --duration 3 -o w.md").code, 0);
  const std::string wheel = text_of(folder / "w.md");
  EXPECT_THAT(wheel, HasSubstr("| Wheel h, body axes | (500, 30, 0) | g cm²/s |"));
  EXPECT_THAT(wheel, HasSubstr("| Steady rotations with this L | 6 |"));
  EXPECT_THAT(wheel, HasSubstr("differences from the method taylor with the tolerance 1e-15"));
  EXPECT_THAT(wheel, HasSubstr("twrench study t-handle --wheel 500,30,0 --duration 3"));
  EXPECT_THAT(wheel, HasSubstr("It turns over at "));
  EXPECT_THAT(wheel, HasSubstr("Energy drift"));
  ASSERT_EQ(
      run_twrench(folder, "report tennis-racket --energy-loss-time 1 --duration 9 -o l.md").code,
      0);
  const std::string loss = text_of(folder / "l.md");
  EXPECT_THAT(loss, HasSubstr("Energy T at the end"));
  EXPECT_THAT(loss, HasSubstr("| Time of the energy loss τ | 1 | s |"));
  EXPECT_THAT(loss, HasSubstr("at first and 90 degrees at the end"));
  EXPECT_THAT(loss, HasSubstr("| Energy error |"));
  // The geometric phase of a rigid body.
  ASSERT_EQ(run_twrench(folder,
                        "report --inertia 3,5,9 --omega 0,0.4,0.0011111111111111111 "
                        "--duration 9 -o r.md")
                .code,
            0);
  const std::string rigid = text_of(folder / "r.md");
  EXPECT_THAT(rigid, HasSubstr("| Period P in which L returns in the body | 118.11089 | s |"));
  EXPECT_THAT(rigid, HasSubstr("| Its geometric part | -2.7385939 | rad |"));
  EXPECT_THAT(rigid, HasSubstr("| Rotation about L in that time | 44.505827 | rad |"));
}

}  // namespace
}  // namespace twrench
