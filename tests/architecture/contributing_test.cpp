// That CONTRIBUTING.md names only what is there: a stranger finds each place of a recipe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "architecture/markdown.h"

namespace twrench {
namespace {

std::string contributing() { return file_text(project_folder() / "CONTRIBUTING.md"); }

/// A file or folder of the project, and no command line: "src/motion/method.cpp".
bool is_path(const std::string& span) {
  static const std::regex pattern(
      R"((src|include|tests|docs|shaders|scripts|cmake|assets|bench|web|python)/[\w./-]*|[\w.-]+\.md)");
  return std::regex_match(span, pattern);
}

/// "FlipSearch", "half_sizes()", "so3::exp"
bool is_identifier(const std::string& span) {
  static const std::regex pattern(R"([A-Za-z_]\w*(::\w+)*(\(\))?)");
  return std::regex_match(span, pattern);
}

/// The numbered steps of the recipes, each as one text.
std::vector<std::string> steps_of_recipes() {
  static const std::regex step(R"((^|\n)\d+\. [^\n]*(\n {2,}[^\n]*)*)");
  const std::string text = contributing();
  std::vector<std::string> steps;
  for (std::sregex_iterator match(text.begin(), text.end(), step), end; match != end; ++match) {
    steps.push_back(match->str());
  }
  return steps;
}

/// Whether it stands in the text as a word of its own.
bool has_word(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

TEST(Contributing, NamesFilesThatAreThere) {
  int paths = 0;
  for (const std::string& span : code_spans(contributing())) {
    if (!is_path(span)) continue;
    ++paths;
    EXPECT_TRUE(std::filesystem::exists(project_folder() / span)) << span;
  }
  EXPECT_GT(paths, 20);
}

// A step says first in which files, then what of the code is there.
TEST(Contributing, NamesWhatIsInTheFilesOfItsStep) {
  int identifiers = 0;
  for (const std::string& step : steps_of_recipes()) {
    std::string sources;
    for (const std::string& span : code_spans(step)) {
      if (is_path(span) && std::filesystem::is_regular_file(project_folder() / span)) {
        sources += file_text(project_folder() / span);
      }
    }
    for (std::string span : code_spans(step)) {
      if (is_path(span) || !is_identifier(span)) continue;
      if (span.ends_with("()")) span.resize(span.size() - 2);
      ++identifiers;
      EXPECT_TRUE(has_word(sources, span.substr(span.rfind(':') + 1)))
          << span << " is not in the files of this step:" << step;
    }
  }
  EXPECT_GT(identifiers, 20);
}

TEST(Contributing, HasRecipesOfAboutTenLines) {
  const std::string text = contributing();
  for (const char* name : {"method", "shape", "overlay", "view", "theme", "output format"}) {
    const std::regex heading(std::string("\n### Add an? ") + name + "\n");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, heading)) << name;
    const std::string recipe = match.suffix().str().substr(0, match.suffix().str().find("\n#"));
    EXPECT_LE(std::ranges::count(recipe, '\n'), 16) << name;
  }
}

}  // namespace
}  // namespace twrench
