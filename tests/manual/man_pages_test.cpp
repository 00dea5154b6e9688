#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "manual/manual.h"
#include "manual/program.h"
#include "scene/fields.h"

namespace twrench::manual {
namespace {

using testing::HasSubstr;

/// The text as it appears in roff.
std::string with_escaped_hyphens(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '-' ? "\\-" : std::string(1, c);
  return result;
}

bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

TEST(ManPages, HaveEachOptionOfEachCommand) {
  for (const Command& command : all_commands()) {
    const std::string page = written("twrench-" + command.name + ".1");
    for (const Option& option : command.options) {
      for (const std::string& name : option.names) {
        EXPECT_THAT(page, HasSubstr("\\fB" + with_escaped_hyphens(name) + "\\fR")) << command.name;
      }
    }
    for (const Option& argument : command.arguments) {
      EXPECT_THAT(page, HasSubstr("\\fI" + argument.names.front() + "\\fR")) << command.name;
    }
    EXPECT_THAT(written("twrench.1"), HasSubstr("twrench\\-" + command.name + " (1)"));
  }
}

TEST(ManPages, HaveEachExitCode) {
  for (const char* code : {"0", "1", "2", "3", "4", "5", "70", "130, 143"}) {
    EXPECT_THAT(written("twrench.1"), HasSubstr(std::string(".TP\n\\fB") + code + "\\fR\n"));
  }
}

TEST(ManPages, HaveTheExitStatusOfCommandsThatDescribeIt) {
  EXPECT_THAT(written("twrench-doctor.1"), HasSubstr(".SH EXIT STATUS\nExit codes: 0 twrench"));
  EXPECT_THAT(written("twrench-scenes.1"), testing::Not(HasSubstr(".SH EXIT STATUS")));
}

TEST(ManPages, HaveTheExamplesOfTheirCommand) {
  EXPECT_THAT(written("twrench-render.1"),
              HasSubstr(".SH EXAMPLES\n.nf\n.RS 4\ntwrench render dzhanibekov"));
}

TEST(ManPages, OfTheSceneHaveEachField) {
  const std::string page = written("twrench-scene.5");
  for (const scene::Field& field : scene::fields()) {
    EXPECT_THAT(page, HasSubstr("\\fB" + field.key + "\\fR = "));
  }
  for (const char* key : {"shape", "density", "position", "axis", "rotation", "moments"}) {
    EXPECT_THAT(page, HasSubstr(std::string("\\fB") + key + "\\fR = "));
  }
}

TEST(ManPages, HaveShortLinesOfText) {
  for (const Command& command : all_commands()) {
    std::istringstream lines(written("twrench-" + command.name + ".1"));
    bool filled = true;
    for (std::string line; std::getline(lines, line);) {
      if (line == ".nf") filled = false;
      if (line == ".fi") filled = true;
      if (!filled || line.starts_with('.') || line.find(' ') == std::string::npos) continue;
      EXPECT_LE(line.size(), 78U) << command.name << ": " << line;
    }
  }
}

TEST(ManPages, AreWhatRoffExpects) {
  const std::string pages = std::string(TWRENCH_MANUAL) + "/*.[15]";
  if (!is_installed("groff") && !is_installed("mandoc")) GTEST_SKIP() << "neither is installed";
  if (is_installed("groff")) {
    EXPECT_EQ(std::system(("for page in " + pages +
                           "; do groff -ww -man -Tutf8 -z \"$page\" 2>&1; done | (! grep .)")
                              .c_str()),
              0);
  }
  if (is_installed("mandoc")) {
    EXPECT_EQ(std::system(("mandoc -T lint " + pages).c_str()), 0);
  }
}

TEST(ManPages, KeepTextThatLooksLikeARequest) {
  Command command{"try", "Try it", {}, {}, {}, ""};
  command.options = {{{"--a"}, "", ".toml or 'x' or C:\\", "", {}}};
  EXPECT_THAT(command_page(command, {"1", "2026-01-02"}),
              HasSubstr("\n\\&.toml or 'x' or C:\\e.\n"));
}

}  // namespace
}  // namespace twrench::manual
