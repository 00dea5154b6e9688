// THIRD-PARTY.md lists all third-party code and fonts in the program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "architecture/markdown.h"

namespace twrench {
namespace {

using testing::HasSubstr;

std::string notices() { return file_text(project_folder() / "THIRD-PARTY.md"); }

TEST(ThirdParty, ListsEachLibraryThatIsCompiledIn) {
  std::set<std::string> listed;
  for (const auto& row : markdown_table(notices(), "what")) listed.insert(row.at(0));
  int compiled_in = 0;
  const std::string architecture = file_text(project_folder() / "docs/architecture.md");
  for (const auto& row : markdown_table(architecture, "library")) {
    if (row.at(2) != "compiled in") continue;
    ++compiled_in;
    EXPECT_TRUE(listed.contains(row.at(0))) << row.at(0);
  }
  EXPECT_GT(compiled_in, 4);
}

// The listed packages of fonts are those from which the build embeds fonts.
TEST(ThirdParty, ListsEachFontOfTheBuild) {
  const std::string dependencies = file_text(project_folder() / "cmake/RenderDependencies.cmake");
  const std::regex package("fonts-[a-z0-9-]+");
  std::set<std::string> packages;
  for (std::sregex_iterator match(dependencies.begin(), dependencies.end(), package), end;
       match != end; ++match) {
    packages.insert(match->str());
  }
  ASSERT_FALSE(packages.empty());
  for (const std::string& name : packages) EXPECT_THAT(notices(), HasSubstr(name));
}

TEST(ThirdParty, SaysOfEachWhoseItIsUnderWhichLicenceAndWhereItsTextIs) {
  for (const auto& row : markdown_table(notices(), "what")) {
    ASSERT_EQ(row.size(), 4U) << row.at(0);
    for (const std::string& cell : row) EXPECT_FALSE(cell.empty()) << row.at(0);
    EXPECT_THAT(row.at(3), HasSubstr("/usr/share/doc/")) << row.at(0);
  }
}

}  // namespace
}  // namespace twrench
