// The checker finds each kind of violation in made-up rooms.
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
    "| `picture` | pictures | `picture/space` | |\n"
    "| `picture/space` | places | `math` | |\n\n"
    "| library | headers |\n"
    "|---|---|\n"
    "| Eigen | `Eigen/` |\n"
    "| zlib | `zlib.h` |\n";
const std::set<std::string> known_rooms{"math", "picture", "picture/space"};

std::vector<Include> sound_includes() {
  return {{"math/so3.h:1", "math", "Eigen/Core", false},
          {"math/so3.h:2", "math", "cmath", false},
          {"picture/view.cpp:1", "picture", "picture/space/camera.h", true},
          {"picture/view.cpp:2", "picture", "picture/view.h", true},
          {"picture/view.cpp:3", "picture", "embedded/shaders.h", true},
          {"picture/space/camera.h:1", "picture/space", "math/so3.h", true}};
}

/// The violations after adding this line.
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
  EXPECT_THAT(broken_with({"math/so3.h:3", "math", "picture/space/camera.h", true}),
              ElementsAre("math/so3.h:3: math may not include picture/space "
                          "(picture/space/camera.h)"));
}

TEST(IncludeRules, ANestedRoomIsNotItsParent) {
  EXPECT_THAT(broken_with({"picture/space/camera.h:2", "picture/space", "picture/view.h", true}),
              ElementsAre(HasSubstr("picture/space may not include picture")));
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
  EXPECT_THAT(broken_rules(read_include_rules(document),
                           {"math", "picture", "picture/space", "mesh"}, sound_includes()),
              ElementsAre("mesh has no row in the table"));
}

TEST(IncludeRules, ARowWithoutAFolder) {
  std::vector<Include> includes = sound_includes();
  std::erase_if(includes, [](const Include& include) { return include.room == "picture"; });
  EXPECT_THAT(broken_rules(read_include_rules(document), {"math", "picture/space"}, includes),
              Contains("picture has a row, but no sources"));
}

TEST(IncludeRules, AnArrowThatNobodyNeeds) {
  std::vector<Include> includes = sound_includes();
  includes.pop_back();
  EXPECT_THAT(broken_rules(read_include_rules(document), known_rooms, includes),
              ElementsAre(HasSubstr("picture/space does not include math")));
}

// A room that only includes from a circle is not in the circle.
TEST(IncludeRules, ACircle) {
  IncludeRules rules = read_include_rules(document);
  rules.rooms["math"].rooms = {"picture/space"};
  EXPECT_THAT(rooms_in_circles(rules), ElementsAre("math", "picture/space"));
}

}  // namespace
}  // namespace twrench
