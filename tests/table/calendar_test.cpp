#include "table/calendar.h"

#include <gmock/gmock.h>
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

TEST(Calendar, ReadsOtherFormsWhoseOrderIsStated) {
  const double t = number_of("2026-11-28T14:05:06.5", Calendar::date_time).value;
  for (const char* text :
       {"28/11/2026 14:05:06.5", "11/28/2026 14:05:06.5", "28.11.2026 14:05:06,5",
        "28 Nov 2026 14:05:06.500", "2026 NOV 28 14:05:06.5", "2026-Nov-28 14:05:06:500",
        "28-NOV-2026 2:05:06.5 PM", "11/28/2026 2:05:06.5pm", "20261128T140506.5Z",
        "2026-332T14:05:06.5", "28/11/2026 14:05:06.5 UTC"}) {
    EXPECT_EQ(number_of(text, Calendar::date_time).value, t) << text;
  }
  EXPECT_EQ(number_of("3.4.2026 9:05", Calendar::date_time).value,
            number_of("2026-04-03T09:05", Calendar::date_time).value);
  EXPECT_EQ(number_of("12:30:00 AM", Calendar::time_of_day).value, 1800);
  EXPECT_EQ(number_of("12:30:00 PM", Calendar::time_of_day).value, 45000);
  EXPECT_EQ(number_of("28/11/2026", Calendar::date).value,
            number_of("2026-11-28", Calendar::date).value);
}

// The differences of times are right in either order as long as the date stays.
TEST(Calendar, AsksForTheOrderOfDayAndMonthOnlyIfItMatters) {
  const std::string first = "time,wx\n03/04/2026 23:59:59.5,1\n";
  const Table one_day = read_table(first + "03/04/2026 23:59:59.75,2\n");
  EXPECT_EQ(one_day.rows[1][0] - one_day.rows[0][0], 0.25);
  EXPECT_EQ(table_error_of(first + "04/04/2026 00:00:00.5,2\n"),
            "run:3: the column 'time': the dates 03/04/2026 and 04/04/2026 may begin with the day "
            "or with the month -- write dates as 2026-03-04");
  EXPECT_EQ(read_table("time,wx\n12/11/2026 23:59:59.5,1\n13/11/2026 00:00:00.5,2\n").rows,
            read_table("time,wx\n2026-11-12 23:59:59.5,1\n2026-11-13 00:00:00.5,2\n").rows);
  EXPECT_EQ(read_table("time,wx\n11/12/2026 23:59:59.5,1\n11/13/2026 00:00:00.5,2\n").rows,
            read_table("time,wx\n2026-11-12 23:59:59.5,1\n2026-11-13 00:00:00.5,2\n").rows);
  EXPECT_THAT(table_error_of("time,wx\n28/11/2026 10:00:00,1\n11/28/2026 10:00:01,2\n"),
              testing::HasSubstr("run:3: "));
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
                           "29/02/2026",
                           "13/13/2026",
                           "28 Foo 2026",
                           "13:00:00 PM",
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
