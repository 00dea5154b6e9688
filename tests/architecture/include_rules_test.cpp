// That the checker finds what it is there to find, on known_rooms that are made up.
#include "architecture/include_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "architecture/markdown.h"

namespace twrench {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string document =
    "# Rooms\n\n"
    "| room | what | may include | libraries |\n"
    "|---|---|---|---|\n"
    "| `math` | numbers | | Eigen |\n"
    "| `render` | pictures | `render/space` | |\n"
    "| `render/space` | places | `math` | |\n\n"
    "| library | headers |\n"
    "|---|---|\n"
    "| Eigen | `Eigen/` |\n"
    "| zlib | `zlib.h` |\n";
const std::set<std::string> known_rooms{"math", "render", "render/space"};

std::vector<Include> sound_includes() {
  return {{"math/so3.h:1", "math", "Eigen/Core", false},
          {"math/so3.h:2", "math", "cmath", false},
          {"render/renderer.cpp:1", "render", "render/space/camera.h", true},
          {"render/renderer.cpp:2", "render", "render/renderer.h", true},
          {"render/renderer.cpp:3", "render", "embedded/shaders.h", true},
          {"render/space/camera.h:1", "render/space", "math/so3.h", true}};
}

/// What is found broken when this line is there too.
std::vector<std::string> broken_with(const Include& include) {
  std::vector<Include> includes = sound_includes();
  includes.push_back(include);
  return broken_rules(read_include_rules(document), known_rooms, includes);
}

TEST(IncludeRules, SoundRoomsBreakNone) {
  const IncludeRules rules = read_include_rules(document);
  EXPECT_THAT(broken_rules(rules, known_rooms, sound_includes()), IsEmpty());
  EXPECT_THAT(rooms_in_circles(rules), IsEmpty());
}

TEST(IncludeRules, AnArrowThatTheTableDoesNotHave) {
  EXPECT_THAT(broken_with({"math/so3.h:3", "math", "render/space/camera.h", true}),
              ElementsAre("math/so3.h:3: math may not include render/space "
                          "(render/space/camera.h)"));
}

TEST(IncludeRules, ANestedRoomIsNotItsParent) {
  EXPECT_THAT(broken_with({"render/space/camera.h:2", "render/space", "render/renderer.h", true}),
              ElementsAre(HasSubstr("render/space may not include render")));
}

TEST(IncludeRules, ALibraryThatTheRoomDoesWithout) {
  EXPECT_THAT(broken_with({"math/so3.h:3", "math", "zlib.h", false}),
              ElementsAre(HasSubstr("math may not include zlib")));
}

TEST(IncludeRules, AHeaderOfNoKnownLibrary) {
  EXPECT_THAT(broken_with({"math/so3.h:3", "math", "opencv2/core.hpp", false}),
              ElementsAre(HasSubstr("<opencv2/core.hpp> is of no known library")));
}

TEST(IncludeRules, AFolderWithoutARow) {
  EXPECT_THAT(broken_rules(read_include_rules(document), {"math", "render", "render/space", "mesh"},
                           sound_includes()),
              ElementsAre("mesh has no row in the table"));
}

TEST(IncludeRules, ARowWithoutAFolder) {
  std::vector<Include> includes = sound_includes();
  std::erase_if(includes, [](const Include& include) { return include.room == "render"; });
  EXPECT_THAT(broken_rules(read_include_rules(document), {"math", "render/space"}, includes),
              Contains("render has a row, but no sources"));
}

TEST(IncludeRules, AnArrowThatNobodyNeeds) {
  std::vector<Include> includes = sound_includes();
  includes.pop_back();
  EXPECT_THAT(broken_rules(read_include_rules(document), known_rooms, includes),
              ElementsAre(HasSubstr("render/space does not include math")));
}

// Not the room that only looks at a circle from above.
TEST(IncludeRules, ACircle) {
  IncludeRules rules = read_include_rules(document);
  rules.rooms["math"].rooms = {"render/space"};
  EXPECT_THAT(rooms_in_circles(rules), ElementsAre("math", "render/space"));
}

}  // namespace
}  // namespace twrench
