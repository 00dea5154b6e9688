#include "table/calendar.h"

#include <gtest/gtest.h>

#include <string>

#include "table/read_table.h"

namespace twrench::table {
namespace {

/// The number with all its digits, and the kind: "1772619065.25 date_time".
Number number_of(std::string_view text, Calendar kind) {
  Number number;
  EXPECT_EQ(read_calendar(text, number), kind) << text;
  return number;
}

TEST(Calendar, ReadsDatesAndTimesOfIso8601) {
  const double t = 1772619065.25;
  for (const char* text :
       {"2026-03-04T10:11:05.25", "2026-03-04 10:11:05.25", "2026/03/04 10:11:05,250",
        "2026-03-04T10:11:05.25Z", "2026-03-04T11:11:05.25+01:00", "2026-03-04t08:11:05.25-0200",
        "2026-03-04 10:11:05.25 +00", "2026-063T10:11:05.25"}) {
    EXPECT_EQ(number_of(text, Calendar::date_time).value, t) << text;
  }
  EXPECT_EQ(number_of("2026-03-04T10:11", Calendar::date_time).value, 1772619060);
  EXPECT_EQ(number_of("2026-03-04", Calendar::date).value, 1772582400);
  EXPECT_EQ(number_of("10:11:05.25", Calendar::time_of_day).value, 36665.25);
  EXPECT_EQ(number_of("1969-12-31T23:59:59.25", Calendar::date_time).value, -0.75);
  EXPECT_EQ(number_of("2024-366T00:00:00", Calendar::date_time).value,
            number_of("2024-12-31T00:00:00", Calendar::date_time).value);
}

TEST(Calendar, KeepsAllDigits) {
  const Number a = number_of("2026-03-04T10:11:05.123456789", Calendar::date_time);
  const Number b = number_of("2026-03-04T10:11:05.123456788", Calendar::date_time);
  EXPECT_EQ(a.decimals, 9);
  EXPECT_NEAR((a.value - b.value) + (a.rest - b.rest), 1e-9, 1e-16);
  EXPECT_EQ(number_of("2026-03-04T10:11:05.020", Calendar::date_time).decimals, 3);
}

// A leap second has the number of the second after it, so that the clock does not stand still.
TEST(Calendar, ReadsALeapSecond) {
  EXPECT_EQ(number_of("2016-12-31T23:59:60.5", Calendar::date_time).value,
            number_of("2017-01-01T00:00:00.5", Calendar::date_time).value);
}

TEST(Calendar, ReadsNothingElse) {
  Number number;
  for (const char* text : {"",
                           "2026",
                           "2026-13-01",
                           "2026-02-29",
                           "2025-366",
                           "2026-000",
                           "04-03-2026",
                           "03/04/2026",
                           "2026-03-04T",
                           "2026-03-04T24:00:00",
                           "2026-03-04T10:60:00",
                           "2026-03-04T10:11:61",
                           "2026-03-04T10:11:05.",
                           "2026-03-04T10:11:05.1234567891",
                           "2026-03-04T10:11:05+1",
                           "2026-03-04T10:11:05 CET",
                           "2026-03-04x",
                           "10:11:05x",
                           "10",
                           "-2026-03-04"}) {
    EXPECT_EQ(read_calendar(text, number), Calendar::none) << text;
  }
}

TEST(Calendar, WritesWhatItReads) {
  for (const char* text : {"2026-03-04T10:11:05.020", "1969-12-31T23:59:59.25",
                           "2026-03-04T10:11:05", "2026-03-04T10:11:05.123456789"}) {
    EXPECT_EQ(calendar_text(Calendar::date_time, number_of(text, Calendar::date_time)), text);
  }
  EXPECT_EQ(calendar_text(Calendar::time_of_day, number_of("10:11:05.5", Calendar::time_of_day)),
            "10:11:05.5");
  EXPECT_EQ(calendar_text(Calendar::date, number_of("2026-03-04", Calendar::date)), "2026-03-04");
}

TEST(Calendar, IsReadFromCellsAndFromJson) {
  using Rows = std::vector<std::vector<double>>;
  EXPECT_EQ(read_table("time,wx\n2026-03-04T23:59:59.5,1\n2026-03-05T00:00:00.5,2\n").rows,
            (Rows{{1772668799.5, 1}, {1772668800.5, 2}}));
  EXPECT_EQ(read_table("[{\"t\": \"1970-01-01T00:00:01Z\", \"wx\": 1}]").rows, (Rows{{1, 1}}));
  EXPECT_EQ(table_error_of("time,wx\n2026-03-04T23:59:59.5,1\n0.5,2\n"),
            "run:3: the column 'time': '0.5' is no calendar time of the form in the first row -- "
            "write all times as 2026-03-04T10:11:05.25, with at most nine decimals");
  EXPECT_EQ(table_error_of("[{\"t\": \"1970-01-01\"}, {\"t\": 3}]").substr(0, 9), "run:1: th");
}

}  // namespace
}  // namespace twrench::table
