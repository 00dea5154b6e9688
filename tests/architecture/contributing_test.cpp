// CONTRIBUTING.md names only files and identifiers that exist, so that a newcomer finds each place
// in a recipe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <regex>

#include "architecture/markdown.h"

namespace twrench {
namespace {

std::string contributing() { return file_text(project_folder() / "CONTRIBUTING.md"); }

/// Whether the text is a file or folder of the project instead of a command line:
/// "src/motion/method.cpp".
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

/// Returns the text of each numbered step of the recipes.
std::vector<std::string> steps_of_recipes() {
  static const std::regex step(R"((^|\n)\d+\. [^\n]*(\n {2,}[^\n]*)*)");
  const std::string text = contributing();
  std::vector<std::string> steps;
  for (std::sregex_iterator match(text.begin(), text.end(), step), end; match != end; ++match) {
    steps.push_back(match->str());
  }
  return steps;
}

/// Whether the text contains the whole word.
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

// A step names its files first, then identifiers in them.
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

constexpr std::array recipe_names{"method", "shape",         "overlay",   "view",
                                  "theme",  "output format", "convention"};

/// Returns the recipe below a heading such as "### Add a method", or nothing if there is none.
std::string recipe_of(const std::string& name) {
  const std::string text = contributing();
  std::smatch match;
  if (!std::regex_search(text, match, std::regex("\n### Add an? " + name + "\n"))) return {};
  const std::string rest = match.suffix();
  return rest.substr(0, rest.find("\n#"));
}

TEST(Contributing, HasRecipesOfAboutTenLines) {
  for (const char* const name : recipe_names) {
    EXPECT_THAT(recipe_of(name), testing::Not(testing::IsEmpty())) << name;
    EXPECT_LE(std::ranges::count(recipe_of(name), '\n'), 16) << name;
  }
}

/// The files that a patch changes, and those that it creates.
struct Patch {
  std::vector<std::string> changed, created;
};

Patch read_patch(const std::filesystem::path& file) {
  Patch patch;
  static const std::regex names(R"(\n--- (\S+)\n\+\+\+ b/(\S+))");
  const std::string text = file_text(file);
  for (std::sregex_iterator match(text.begin(), text.end(), names), end; match != end; ++match) {
    ((*match)[1] == "/dev/null" ? patch.created : patch.changed).push_back((*match)[2]);
  }
  return patch;
}

/// The folders of the files that a recipe names, such as "src/body/shapes".
std::vector<std::string> folders_in(const std::string& recipe) {
  std::vector<std::string> folders;
  for (const std::string& span : code_spans(recipe)) {
    if (is_path(span)) folders.push_back(std::filesystem::path(span).parent_path().string());
  }
  return folders;
}

// A recipe names every file that its example changes. A new source is in the folder of a named
// file.
TEST(Contributing, HasRecipesThatNameEachFileOfTheirExamples) {
  using testing::Contains;
  for (const char* const name : recipe_names) {
    const std::string recipe = recipe_of(name);
    std::string file = name;
    std::ranges::replace(file, ' ', '-');
    const Patch patch = read_patch(project_folder() / "tests/recipes" / (file + ".patch"));
    EXPECT_FALSE(patch.changed.empty()) << name;
    for (const std::string& path : patch.changed) {
      EXPECT_THAT(code_spans(recipe), Contains(path)) << "not named by: Add a " << name;
    }
    for (const std::string& path : patch.created) {
      const std::string folder = std::filesystem::path(path).parent_path().string();
      EXPECT_THAT(folders_in(recipe), Contains(folder)) << path << ", Add a " << name;
    }
  }
}

}  // namespace
}  // namespace twrench
