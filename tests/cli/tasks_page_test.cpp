// The commands in docs/tasks.md print the output shown there.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "cli/twrench.h"

namespace twrench {
namespace {

/// A command of the page and the lines that follow it.
struct Session {
  std::string command;
  std::vector<std::string> output;
};

std::vector<Session> sessions(const std::string& page) {
  const std::string prompt = "    $ ", indent = "    ";
  std::vector<Session> found;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(prompt)) {
      found.push_back({line.substr(prompt.size()), {}});
      inside = true;
    } else if (inside && (line.starts_with(indent) || line.empty())) {
      if (!line.empty()) found.back().output.push_back(line.substr(indent.size()));
    } else {
      inside = false;
    }
  }
  return found;
}

std::vector<std::string> words(std::string line) {
  for (char& c : line) c = c == ',' ? ' ' : c;
  std::istringstream stream(line);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

/// Whether numbers agree to the printed digits, except for rounding errors.
bool agree(const std::string& expected, const std::string& actual) {
  if (expected == actual) return true;
  char *end = nullptr, *other_end = nullptr;
  const double a = std::strtod(expected.c_str(), &end);
  const double b = std::strtod(actual.c_str(), &other_end);
  if (*end != '\0' || *other_end != '\0') return false;
  constexpr double rounding = 1e-10;
  if (std::abs(a) < rounding && std::abs(b) < rounding) return true;
  const bool is_error = expected.find('e') != std::string::npos;
  return std::abs(a - b) <= (is_error ? 0.011 : 1e-8) * std::abs(a);
}

void expect_alike(const std::string& expected, const std::string& actual) {
  const std::vector<std::string> a = words(expected), b = words(actual);
  ASSERT_EQ(a.size(), b.size()) << expected << "\n" << actual;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(agree(a[i], b[i])) << a[i] << " is " << b[i] << " in\n" << expected;
  }
}

TEST(TasksPage, ShowsWhatItsCommandsPrint) {
  const ScratchFolder folder;
  const auto all = sessions(text_of(TWRENCH_TESTS_DIR "/../docs/tasks.md"));
  EXPECT_GE(all.size(), 13U);
  for (const Session& session : all) {
    if (session.command.starts_with("twrench render ")) continue;  // slow, and tested elsewhere
    const Outcome run = run_shell(folder, "twrench() { \"$TWRENCH\" \"$@\"; }; " + session.command);
    EXPECT_EQ(run.code, 0) << session.command << "\n" << run.err;
    std::vector<std::string> printed;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) printed.push_back(line);
    }
    ASSERT_EQ(session.output.size(), printed.size()) << session.command;
    for (std::size_t i = 0; i < printed.size(); ++i) expect_alike(session.output[i], printed[i]);
  }
}

}  // namespace
}  // namespace twrench
