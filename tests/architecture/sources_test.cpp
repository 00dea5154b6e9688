// That the sources follow docs/architecture.md, and the document the sources.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "architecture/include_rules.h"
#include "architecture/markdown.h"

namespace twrench {
namespace {

using testing::IsEmpty;

std::string architecture() { return file_text(project_folder() / "docs/architecture.md"); }

TEST(Sources, IncludeOnlyWhatTheDocumentSaysTheyMay) {
  const auto src = project_folder() / "src";
  const std::vector<Include> includes = read_includes(src);
  ASSERT_GT(includes.size(), 500U);  // it looked in the right place
  EXPECT_THAT(broken_rules(read_include_rules(architecture()), read_rooms(src), includes),
              IsEmpty());
}

TEST(Sources, HaveNoCircle) {
  EXPECT_THAT(rooms_in_circles(read_include_rules(architecture())), IsEmpty());
}

// The dynamics are a library of their own, and build where there is no OpenGL, no font, no ffmpeg.
TEST(Sources, OfTheDynamicsNeedNoPicture) {
  const IncludeRules rules = read_include_rules(architecture());
  const std::set<std::string> dynamics{"base", "math", "body", "motion", "study"};
  for (const std::string& room : dynamics) {
    ASSERT_TRUE(rules.rooms.contains(room)) << room;
    for (const std::string& to : rules.rooms.at(room).rooms) {
      EXPECT_TRUE(dynamics.contains(to)) << room << " includes " << to;
    }
    for (const char* library : {"OpenGL", "EGL", "GLM", "stb", "Cairo", "CLI11"}) {
      EXPECT_FALSE(rules.rooms.at(room).libraries.contains(library)) << room << ": " << library;
    }
  }
}

// One place takes what is missing in a machine for what it is: no header of a driver is needed to
// use a context.
TEST(Sources, GiveNoDriversHeaderAway) {
  for (const Include& include : read_includes(project_folder() / "src")) {
    const bool is_header = include.place.find(".h:") != std::string::npos;
    const bool is_drivers = include.header.starts_with("EGL/") || include.header == "GL/osmesa.h";
    EXPECT_FALSE(is_header && is_drivers) << include.place << " includes " << include.header;
  }
}

// Each piece of hand-work names a file: what is gone is not defended any more.
TEST(Sources, HaveTheHandWorkThatTheDocumentExplains) {
  for (const auto& row : markdown_table(architecture(), "ours")) {
    for (const std::string& path : split_list(row.at(1))) {
      EXPECT_TRUE(std::filesystem::exists(project_folder() / "src" / path)) << path;
    }
    EXPECT_GT(row.at(2).size(), 20U) << row.at(0) << " says no reason";
  }
}

}  // namespace
}  // namespace twrench
