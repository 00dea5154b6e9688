#include "table/dialect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace twrench::table {
namespace {

using testing::ElementsAre;

char separator_in(std::string_view text) {
  return detect_dialect(read_sample(Input("run", text), 0), "run").separator;
}

TEST(Dialect, IsThatWhichMakesTheMostNumbers) {
  EXPECT_EQ(separator_in("time (s),rate of turn\n0,1\n2,3\n"), ',');
  EXPECT_EQ(separator_in("a;b;c,d\n1;2;3\n"), ';');
  EXPECT_EQ(separator_in("0,1 0,2\n0,3 0,4\n"), ' ');
  EXPECT_EQ(separator_in("0,1;0,2\n0,3;0,4\n"), ';');
  EXPECT_EQ(separator_in("date\tt\n2026-11-23 05:00\t1\n2026-11-23 06:00\t2\n"), '\t');
}

// As GMAT and SPICE write them.
TEST(Dialect, JoinsDatesBetweenBlanks) {
  for (const char* date : {"01 Jan 2026 12:00:00.000", "2026 JAN 01 12:00:00", "1 Mar 2026"}) {
    const std::string line = std::string(date) + "   0.5 nan 3";
    std::vector<std::string_view> cells;
    split_cells(line, ' ', cells);
    EXPECT_EQ(cells, (std::vector<std::string_view>{date, "0.5", "nan", "3"}));
  }
}

TEST(Dialect, SplitsCells) {
  std::vector<std::string_view> cells;
  EXPECT_TRUE(split_cells(" a , \"b,c\" ,,d", ',', cells));
  EXPECT_THAT(cells, ElementsAre("a", "b,c", "", "d"));
  EXPECT_TRUE(split_cells("  a \t \"b c\"  d ", ' ', cells));
  EXPECT_THAT(cells, ElementsAre("a", "b c", "d"));
  EXPECT_TRUE(split_cells("\t\ta", '\t', cells));
  EXPECT_THAT(cells, ElementsAre("", "", "a"));
  EXPECT_FALSE(split_cells("a,\"b", ',', cells));
}

}  // namespace
}  // namespace twrench::table
