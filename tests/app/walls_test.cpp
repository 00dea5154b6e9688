// The libraries must not mention options of the command line or exit codes of the process.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace twrench::app {
namespace {

namespace fs = std::filesystem;

/// Arguments of other programs.
constexpr std::array foreign{"\"--default-settings\""};  // gnuplot's, without a user's ~/.gnuplot

/// The source that prints command lines. The others mention an argument (base/words.h), which
/// the program words as an option.
constexpr std::string_view of_command_lines = "src/report/command_lines.cpp";

struct Match {
  std::string file, text;
};

/// Whether a source belongs to the command line: the commands, and the manual of their options.
bool is_of_command_line(const std::string& name) {
  return name.starts_with("src/app/") || name.starts_with("src/manual/");
}

/// The matches of a pattern in the sources of all libraries, line by line.
std::vector<Match> matches_in_libraries(const std::regex& pattern) {
  std::vector<Match> matches;
  std::size_t files = 0;
  const fs::path project = fs::path(TWRENCH_TESTS_DIR).parent_path();
  for (const char* folder : {"src", "include"}) {
    for (const auto& entry : fs::recursive_directory_iterator(project / folder)) {
      const std::string name = fs::relative(entry.path(), project).string();
      const std::string extension = entry.path().extension().string();
      if (is_of_command_line(name) || (extension != ".cpp" && extension != ".h")) continue;
      ++files;
      std::ifstream source(entry.path());
      for (std::string line; std::getline(source, line);) {
        for (std::sregex_iterator i(line.begin(), line.end(), pattern), end; i != end; ++i) {
          matches.push_back({name, i->str()});
        }
      }
    }
  }
  EXPECT_GT(files, 100U);
  return matches;
}

TEST(Walls, NoLibraryNamesAnOption) {
  const std::regex literal("\"([^\"\\\\]|\\\\.)*\"");
  const std::regex option("(^|[^-\\w])--[a-z]");
  const std::regex style(R"(style=\\"[^"]*)");  // with custom properties of CSS, such as --w
  for (const auto& [file, text] : matches_in_libraries(literal)) {
    if (file == of_command_lines || std::ranges::find(foreign, text) != foreign.end()) continue;
    EXPECT_FALSE(std::regex_search(std::regex_replace(text, style, ""), option))
        << file << ": " << text;
  }
}

TEST(Walls, NoLibraryKnowsAnExitCode) {
  for (const auto& [file, text] : matches_in_libraries(std::regex("ExitCode|exit_code"))) {
    ADD_FAILURE() << file << ": " << text;
  }
}

}  // namespace
}  // namespace twrench::app
