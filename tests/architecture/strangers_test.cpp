// The files that explain how to cite, to report and to contribute exist and are up to date.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "architecture/markdown.h"

namespace twrench {
namespace {

using testing::HasSubstr;

std::string text_of(const std::string& file) { return file_text(project_folder() / file); }

/// The first group of a pattern in a file of the project.
std::string found_in(const std::string& file, const std::string& pattern) {
  const std::string text = text_of(file);
  std::smatch match;
  return std::regex_search(text, match, std::regex(pattern)) ? match[1].str() : "not in " + file;
}

TEST(Strangers, CiteTheReleaseOfTheSources) {
  EXPECT_EQ(found_in("CITATION.cff", "\nversion: (\\S+)\n"),
            found_in("CMakeLists.txt", "project\\(twrench VERSION ([0-9.]+)"));
  EXPECT_EQ(found_in("CITATION.cff", "\ndate-released: (\\S+)\n"),
            found_in("CMakeLists.txt", "set\\(TWRENCH_RELEASE_DATE ([0-9-]+)\\)"));
  EXPECT_EQ(found_in("CITATION.cff", "\n  - name: (.*)\n"),
            found_in("LICENSE", "Copyright \\(c\\) [0-9]+ (.*)\n"));
}

TEST(Strangers, FindTheWayInTheReadme) {
  const std::string readme = text_of("README.md");
  for (const char* file :
       {"CITATION.cff", ".github/SECURITY.md", ".github/CODE_OF_CONDUCT.md", "CONTRIBUTING.md",
        "LICENSE", "THIRD-PARTY.md", ".github/ISSUE_TEMPLATE/bug.yml", "docs/README.md",
        "docs/tutorial.md", "docs/versioning.md"}) {
    EXPECT_THAT(readme, HasSubstr("](" + std::string(file) + ")"));
    EXPECT_TRUE(std::filesystem::exists(project_folder() / file)) << file;
  }
}

// The workflows, the forms and the documents name scripts of the project, which may be renamed.
TEST(Strangers, RunScriptsThatAreThere) {
  const std::regex script("scripts/(maintain/)?[a-z0-9_]+\\.sh");
  int scripts = 0;
  for (const char* file :
       {".github/workflows/nightly.yml", ".github/workflows/test.yml",
        ".github/PULL_REQUEST_TEMPLATE.md", "Dockerfile", "README.md", "CONTRIBUTING.md",
        "docs/install.md", "docs/platforms.md", "docs/testing.md"}) {
    const std::string text = text_of(file);
    for (std::sregex_iterator match(text.begin(), text.end(), script), end; match != end; ++match) {
      ++scripts;
      EXPECT_TRUE(std::filesystem::exists(project_folder() / match->str())) << match->str();
    }
  }
  EXPECT_GE(scripts, 20);
}

TEST(Strangers, RunEveryCommandInTheContainer) {
  const std::string container = text_of("Dockerfile");
  EXPECT_THAT(container, HasSubstr("\nENTRYPOINT [\"twrench\"]\n"));
  EXPECT_THAT(container, HasSubstr(" gnuplot-nox "));  // for plot and report
  EXPECT_THAT(text_of("docs/install.md"),
              HasSubstr("docker run --rm -v \"$PWD:/out\" twrench render"));
}

}  // namespace
}  // namespace twrench
