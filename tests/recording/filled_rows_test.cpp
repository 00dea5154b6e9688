#include "recording/filled_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "table/error.h"

namespace twrench::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The times of the rows, the ones that were left out last, and the error.
struct Pass {
  std::vector<double> times;
  std::string left_out, error;
};

Pass pass_over(const std::string& rows) {
  const std::string text = "t,wx\n" + rows;
  FilledRows table(table::open_table("run", text));
  Pass pass;
  table.begin_pass(std::array<std::size_t, 2>{0, 1});
  std::array<table::Number, 2> numbers;
  try {
    while (table.next(numbers)) pass.times.push_back(numbers[0].value);
  } catch (const table::BadTable& error) {
    pass.error = error.what();
  }
  pass.left_out = table.left_out();
  return pass;
}

TEST(FilledRows, LeaveOutThoseAtTheEndsThatLackANumber) {
  const Pass pass = pass_over("0,\n1,nan\n2,5\n3,6\n4,\n");
  EXPECT_THAT(pass.times, ElementsAre(2, 3));
  EXPECT_EQ(pass.left_out, "run:2 to run:3, run:6");
  EXPECT_THAT(pass.error, IsEmpty());
}

TEST(FilledRows, AreAllRowsOfAFullTable) {
  const Pass pass = pass_over("0,4\n1,5\n");
  EXPECT_THAT(pass.times, ElementsAre(0, 1));
  EXPECT_THAT(pass.left_out, IsEmpty());
}

TEST(FilledRows, MayNotHaveGaps) {
  EXPECT_THAT(pass_over("0,4\n1,\n2,nan\n3,6\n").error,
              HasSubstr("run:3: the column 'wx': the cell is empty"));
  EXPECT_THAT(pass_over("0,4\n1,nan\n2,6\n").error,
              HasSubstr("run:3: the column 'wx': nan is not finite"));
}

TEST(FilledRows, AreNeeded) {
  EXPECT_THAT(pass_over("0,\n1,nan\n").error,
              HasSubstr("run:2: the column 'wx': the cell is empty"));
}

}  // namespace
}  // namespace twrench::recording
