#include "app/terminal/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace twrench::app {
namespace {

using testing::StartsWith;

TEST(BarLine, FitsTheTerminal) {
  const std::string figures = "480/960  11.7 frames/s  0:41 left";
  for (const int columns : {1, 2, 20, 34, 40, 42, 43, 60, 80, 300}) {
    EXPECT_EQ(bar_line(0.5, figures, columns).size(), std::max(columns - 1, 1)) << columns;
  }
  EXPECT_THAT(bar_line(0.5, figures, 80), StartsWith("[###############...............] 480/960"));
  EXPECT_THAT(bar_line(0.5, figures, 300), StartsWith("[###############...............] 480/960"));
  EXPECT_THAT(bar_line(0.5, figures, 47), StartsWith("[#####.....] 480/960"));
  EXPECT_THAT(bar_line(0.5, figures, 40), StartsWith("480/960"));
  EXPECT_EQ(bar_line(0.5, figures, 8), "480/960");
}

TEST(BarLine, IsEmptyAtFirstAndFullInTheEnd) {
  EXPECT_THAT(bar_line(0.0, "x", 20), StartsWith("[...............] x"));
  EXPECT_THAT(bar_line(1.0, "x", 20), StartsWith("[###############] x"));
}

}  // namespace
}  // namespace twrench::app
