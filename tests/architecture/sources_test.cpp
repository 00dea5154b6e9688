// The sources and docs/architecture.md agree.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "architecture/include_rules.h"
#include "architecture/markdown.h"

namespace twrench {
namespace {

using testing::IsEmpty;

std::string architecture() { return file_text(project_folder() / "docs/architecture.md"); }

std::filesystem::path sources() { return project_folder() / "src"; }
std::filesystem::path public_headers() { return project_folder() / "include/twrench"; }

std::vector<Include> all_includes() {
  std::vector<Include> includes = read_includes(sources());
  std::ranges::move(read_includes(public_headers()), std::back_inserter(includes));
  return includes;
}

TEST(Sources, IncludeOnlyWhatTheDocumentSaysTheyMay) {
  const std::vector<Include> includes = all_includes();
  ASSERT_GT(includes.size(), 500U);  // it looked in the right place
  std::set<std::string> rooms = read_rooms(sources());
  rooms.merge(read_rooms(public_headers()));
  rooms.erase("");  // twrench.h, which includes all public headers
  EXPECT_THAT(broken_rules(read_include_rules(architecture()), rooms, includes), IsEmpty());
}

/// The target that compiles the files of a room.
std::string target_of(const std::string& room) {
  static const std::set<std::string> dynamics{"base", "math", "body", "motion", "study"};
  const std::string top = room.substr(0, room.find('/'));
  return dynamics.contains(top) ? "dynamics" : top;
}

TEST(Sources, AreLinkedToTheTargetsOfTheRoomsThatTheyInclude) {
  std::map<std::string, std::set<std::string>> included, linked;
  for (const auto& [name, room] : read_include_rules(architecture()).rooms) {
    for (const std::string& other : room.rooms) {
      if (target_of(other) != target_of(name)) included[target_of(name)].insert(target_of(other));
    }
  }
  const std::regex link(R"(LINKS((?:\s+twrench_\w+)*))");
  const std::regex target("twrench_(\\w+)");
  for (const auto& [name, others] : included) {
    const std::string text = file_text(sources() / name / "CMakeLists.txt");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, link)) << name;
    const std::string targets = match[1];
    for (std::sregex_iterator at(targets.begin(), targets.end(), target), end; at != end; ++at) {
      linked[name].insert((*at)[1]);
    }
  }
  EXPECT_EQ(linked, included);
}

// Programs that link the library need only Eigen to compile.
TEST(Sources, OfThePublicHeadersNeedEigenAlone) {
  for (const Include& include : read_includes(public_headers())) {
    const bool is_of_a_library = include.header.find_first_of("./") != std::string::npos;
    const bool is_allowed =
        include.header.starts_with("twrench/") || include.header.starts_with("Eigen/");
    EXPECT_FALSE(include.quoted || (is_of_a_library && !is_allowed))
        << include.place << " includes " << include.header;
  }
}

TEST(Sources, HaveNoCircle) {
  EXPECT_THAT(rooms_in_circles(read_include_rules(architecture())), IsEmpty());
}

// The dynamics are a separate library, which builds without OpenGL, fonts and ffmpeg.
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

/// The namespace of the sources in a folder of src or include/twrench.
std::string namespace_of(const std::string& folder) {
  return folder == "base" ? "twrench" : "twrench::" + folder;
}

// In a flat namespace the linker once merged two types with the same name.
TEST(Sources, AreInTheNamespaceOfTheirFolder) {
  // The functions of math have names as short as exp and log.
  const std::set<std::string> of_math{"twrench::so3", "twrench::elliptic", "twrench::elementary"};
  const std::regex opening(R"((^|\n)namespace (twrench[\w:]*) \{)");
  for (const auto& place : {sources(), public_headers()}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(place)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".h") continue;
      const auto relative = std::filesystem::relative(entry.path(), place);
      const std::string folder = relative.begin()->string();
      const std::string text = file_text(entry.path());
      for (std::sregex_iterator at(text.begin(), text.end(), opening), end; at != end; ++at) {
        const std::string name = (*at)[2];
        const bool is_own =
            name == namespace_of(folder) || name.starts_with(namespace_of(folder) + "::");
        EXPECT_TRUE(folder == "math" ? of_math.contains(name) : is_own)
            << relative << " opens " << name;
      }
    }
  }
}

// Only one source depends on the drivers of the machine: using a context needs no header of a
// driver.
TEST(Sources, GiveNoDriversHeaderAway) {
  for (const Include& include : all_includes()) {
    const bool is_header = include.place.find(".h:") != std::string::npos;
    const bool is_drivers = include.header.starts_with("EGL/") || include.header == "GL/osmesa.h";
    EXPECT_FALSE(is_header && is_drivers) << include.place << " includes " << include.header;
  }
}

// Each piece of hand-written code in the table names existing files, so that removed code is no
// longer listed.
TEST(Sources, HaveTheHandWorkThatTheDocumentExplains) {
  for (const auto& row : markdown_table(architecture(), "ours")) {
    for (const std::string& path : split_list(row.at(1))) {
      EXPECT_TRUE(std::filesystem::exists(sources() / path) ||
                  std::filesystem::exists(public_headers() / path))
          << path;
    }
    EXPECT_GT(row.at(2).size(), 20U) << row.at(0) << " says no reason";
  }
}

}  // namespace
}  // namespace twrench
