#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "table/read_table.h"

namespace twrench::table {
namespace {

using testing::HasSubstr;
using Names = std::vector<std::string>;
using Rows = std::vector<std::vector<double>>;

// As rostopic echo and ros2 topic echo print them.
TEST(Yaml, HasARowForEachDocument) {
  const Table table = read_table(
      "header:\n  stamp:\n    sec: 17\n    nanosec: 20\n  frame_id: \"imu link\"\n"
      "angular_velocity:\n  x: 0.5\n  y: -1.0e-05\ncovariance:\n- 1.0\n- 2.0\n---\n"
      "header:\n  stamp:\n    sec: 17\n    nanosec: 40\n  frame_id: \"imu link\"\n"
      "angular_velocity: {x: 1.5, y: 2}\ncovariance: [3, 4]\n---\n",
      {0, 1, 3, 4, 6});
  EXPECT_EQ(table.names,
            (Names{"header.stamp.sec", "header.stamp.nanosec", "header.frame_id",
                   "angular_velocity.x", "angular_velocity.y", "covariance[0]", "covariance[1]"}));
  EXPECT_EQ(table.rows, (Rows{{17, 20, 0.5, -1e-5, 2}, {17, 40, 1.5, 2, 4}}));
}

TEST(Yaml, MayBeAList) {
  const Table table = read_table("# a log\n- t: 0\n  omega: [1, 2]\n- t: 1\n  omega: [3, 4]\n");
  EXPECT_EQ(table.names, (Names{"t", "omega[0]", "omega[1]"}));
  EXPECT_EQ(table.rows, (Rows{{0, 1, 2}, {1, 3, 4}}));
}

TEST(Yaml, IsNotEveryTextWithColons) {
  EXPECT_EQ(read_table("Rate: 50\nt,x,y\n0,1,2\n1,2,3\n").names, (Names{"t", "x", "y"}));
}

TEST(Yaml, NamesTheRowOrTheLineOfAMistake) {
  EXPECT_THAT(file_error_of("t: 0\n---\nt: [0\n---\n"), HasSubstr("run:4: it is no valid YAML"));
  EXPECT_THAT(table_error_of("t: 0\n---\nt: x\n---\n"),
              HasSubstr("run: row 2: the column 't': 'x' is no number"));
  EXPECT_THAT(file_error_of("t: &a 0\n---\nt: *a\n---\n"), HasSubstr("run:3: "));
  EXPECT_THAT(file_error_of("a: &a [0]\nb: &b [*a, *a]\n---\n"),
              HasSubstr("run:2: it refers to another part of the file"));
}

}  // namespace
}  // namespace twrench::table
