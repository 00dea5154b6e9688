#include "app/options/help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace twrench::app {
namespace {

using testing::ElementsAre;

TEST(WordsForParser, AreTheLastFirst) {
  const std::array<const char*, 4> arguments{"twrench", "render", "-o", "a=b"};
  EXPECT_THAT(words_for_parser(4, arguments.data()), ElementsAre("a=b", "-o", "render"));
}

TEST(WordsForParser, AnEmptyValueIsAWordOfItsOwn) {
  const std::array<const char*, 6> arguments{"twrench", "--title=", "--max=1", "x=", "--", "--y="};
  EXPECT_THAT(words_for_parser(6, arguments.data()),
              ElementsAre("--y=", "--", "x=", "--max=1", "", "--title"));
}

}  // namespace
}  // namespace twrench::app
