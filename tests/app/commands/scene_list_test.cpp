#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/commands.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::app {
namespace {

using testing::ContainsRegex;

TEST(SceneList, ListsTheOtherScenesIfOneIsInvalid) {
  const ScratchFolder folder;
  const std::string wrong = (folder / "wrong.toml").string();
  system::write_file_atomically(wrong, std::string("title = 3\n"));
  const std::string list = scene_list({"calm", wrong, "sphere"});
  EXPECT_THAT(list, ContainsRegex("^calm +.*\n.*wrong.toml +invalid: .*wrong.toml:1: title.*\n"
                                  "sphere +[^\n]*\n$"));
}

}  // namespace
}  // namespace twrench::app
