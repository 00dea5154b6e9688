#include "recording/columns/derived_times.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "recording/columns/open_conventions.h"
#include "recording/recording.h"
#include "recording/time_choice.h"
#include "table/error.h"

namespace twrench::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Read {
  std::string column;
  std::vector<double> times;  ///< s since the first row
  Resolution resolution;
};

Read times_of(const std::string& csv) {
  const Recording recording(table::open_table("run.csv", csv));
  const auto open = with_times(recording, conventions(recording.header(), {}));
  EXPECT_EQ(open.size(), 1);
  Read read{open.front().columns.at("t"), {}, {}};
  RowReader rows = recording.rows(open.front());
  Row row;
  while (rows.next(row)) read.times.push_back(row.t);
  read.resolution = rows.time_resolution();
  return read;
}

std::string error_in(const std::string& csv) {
  try {
    times_of(csv);
  } catch (const table::BadTable& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

// As a clock since 1970 in one column, the sum loses no digits.
TEST(DerivedTimes, AddsNanosecondsToSeconds) {
  const Read read = times_of(
      "header.stamp.sec,header.stamp.nanosec,wx,wy,wz\n1700000000,999999999,1,2,3\n"
      "1700000001,0,1,2,3\n1700000001,7,1,2,3\n");
  EXPECT_EQ(read.column, "header.stamp.sec + header.stamp.nanosec");
  EXPECT_THAT(read.times,
              ElementsAre(0, testing::DoubleNear(1e-9, 1e-20), testing::DoubleNear(8e-9, 1e-20)));
  EXPECT_DOUBLE_EQ(read.resolution.absolute, 1e-9);
}

TEST(DerivedTimes, AddsMicrosecondsAndTheTimeOfADay) {
  EXPECT_THAT(times_of("sec,usec,wx,wy,wz\n5,750000,1,2,3\n6,250000,1,2,3\n").times,
              ElementsAre(0, 0.5));
  const Read read =
      times_of("Date,Time,wx,wy,wz\n2026-03-04,23:59:59.5,1,2,3\n2026-03-05,00:00:00.25,1,2,3\n");
  EXPECT_EQ(read.column, "Date + Time");
  EXPECT_THAT(read.times, ElementsAre(0, 0.75));
}

TEST(DerivedTimes, RefusesPartsOutOfRange) {
  EXPECT_EQ(
      error_in("sec,nanosec,wx,wy,wz\n1,0,1,2,3\n2,1000000000,1,2,3\n3,0,1,2,3\n"),
      "run.csv:3: the column 'nanosec': 1000000000 is no part of a time in several columns -- it "
      "must be a whole number from 0 to 999999999, or else name the column of the time");
  EXPECT_THAT(error_in("sec,nanosec,wx,wy,wz\n1.5,0,1,2,3\n2,0,1,2,3\n"), HasSubstr("'sec': 1.5"));
  EXPECT_THAT(error_in("sec,nanosec,wx,wy,wz\n1,-1,1,2,3\n2,0,1,2,3\n"),
              HasSubstr("'nanosec': -1"));
}

TEST(DerivedTimes, LeavesTheOtherColumnsInPlace) {
  const Recording recording(table::open_table("run.csv", "sec,nsec,wx,wy,wz\n1,5,7,8,9\n"));
  EXPECT_THAT(recording.header().names, ElementsAre("sec", "nsec", "wx", "wy", "wz", "sec + nsec"));
  const auto& rows = recording.first_rows({4, 5, 0}).rows;
  EXPECT_EQ(rows[0][0].value, 9);
  EXPECT_EQ(rows[0][1].value, 1.000000005);
  EXPECT_EQ(rows[0][2].value, 1);
}

TEST(CalendarTimes, GoBackOnlyWithAnError) {
  EXPECT_EQ(
      error_in("timestamp,wx,wy,wz\n2026-10-25T02:59:59.9,1,2,3\n2026-10-25T02:00:00.0,1,2,3\n"),
      "run.csv:3: the column 'timestamp': the time 2026-10-25T02:00:00.0 is before that of the "
      "row before, 2026-10-25T02:59:59.9 -- a clock goes back at midnight, at the end of summer "
      "time and at a leap second: write times in UTC with their date, or give each part a file");
  EXPECT_THAT(times_of("timestamp,wx,wy,wz\n2026-10-25T02:59:59.5+02:00,1,2,3\n"
                       "2026-10-25T02:00:00.0+01:00,1,2,3\n")
                  .times,
              ElementsAre(0, 0.5));
  EXPECT_THAT(error_in("wx,wy,t,wz\n1,2,0,2026-10-25\n"), HasSubstr("has calendar times, not wz"));
}

TEST(CalendarTimes, AreInSeconds) {
  const Recording recording(
      table::open_table("run.csv", "time (ms),wx,wy,wz\n10:00:00.5,1,2,3\n10:00:01.0,1,2,3\n"));
  EXPECT_EQ(conventions(recording.header(), {}).front().time_unit, TimeUnit::s);
  Convention said;
  said.time_unit = TimeUnit::ms;
  EXPECT_THROW(conventions(recording.header(), said), table::BadTable);
}

TEST(DerivedTimes, AddsSecondsToTheWeeksOfGps) {
  const Read read = times_of(
      "GPS Week,GPS Seconds,wx,wy,wz\n2445,604799.98,1,2,3\n2446,0.00,1,2,3\n2446,0.02,1,2,3\n");
  EXPECT_EQ(read.column, "GPS Week + GPS Seconds");
  EXPECT_THAT(read.times,
              ElementsAre(0, testing::DoubleNear(0.02, 1e-12), testing::DoubleNear(0.04, 1e-12)));
  EXPECT_THAT(times_of("iTOW,week,wx,wy,wz\n500,7,1,2,3\n520,7,1,2,3\n").times,
              ElementsAre(0, testing::DoubleNear(0.02, 1e-12)));
}

TEST(DerivedTimes, AddsYearsToSeconds) {
  const std::string names = "year,month,day,hour,minute,second,wx,wy,wz\n";
  EXPECT_THAT(times_of(names + "2028,2,28,23,59,59.5,1,2,3\n2028,2,29,0,0,0.25,1,2,3\n").times,
              ElementsAre(0, 0.75));
  EXPECT_THAT(error_in(names + "2026,2,29,0,0,0,1,2,3\n2026,3,1,0,0,0,1,2,3\n"),
              HasSubstr("the column 'day': 29 is no part of a time"));
}

TEST(DerivedTimes, DividesFramesByTheirStatedRate) {
  const std::string rows = "wx,wy,wz\n7,1,2,3\n8,1,2,3\n10,1,2,3\n";
  for (const char* before :
       {"# Frame rate: 50\nframe,", "// Update Rate: 50.0Hz\nFrame#,", "# fps: 50\nsample,",
        "Frame rate: 50 fps 3 cameras\nFrame,", "DataRate=50.000000\nendheader\nFrame,",
        "Frame Time: 0.02\nFrame,",
        "# data, 50 Hz cutoff frequency 10\n# sampling frequency [Hz]: 50\nPacketCounter,",
        "Capture Frame Rate,100,Export Frame Rate,50.000000\nFrame,",
        "Segments\n50\nFrame,Sub Frame,"}) {
    const bool has_sub_frames = std::string(before).ends_with("Sub Frame,");
    std::string text = before + rows;
    for (std::size_t at = 0; has_sub_frames && (at = text.find(",1,2,3", at)) != std::string::npos;
         at += 8)
      text.insert(at, ",0");
    EXPECT_THAT(times_of(text).times,
                ElementsAre(0, testing::DoubleNear(0.02, 1e-15), testing::DoubleNear(0.06, 1e-15)))
        << text;
  }
  EXPECT_EQ(times_of("# rate: 50\nframe,t,wx,wy,wz\n0,1,1,2,3\n1,1.5,1,2,3\n").column, "t");
  for (const char* before :
       {"", "# cutoff frequency: 50 Hz\n", "# frame rate: 50, sample rate: 60\n"})
    EXPECT_THAT(error_in(before + ("frame," + rows)),
                HasSubstr("its rows are numbered by 'frame', but nothing states their rate"));
}

// As Pandas writes an index.
TEST(DerivedTimes, TakesAFirstColumnWithoutNameForTheTimeIfItIsNoNumberOfTheRow) {
  EXPECT_THAT(times_of(",wx,wy,wz\n0.0,1,2,3\n0.02,1,2,3\n").times,
              ElementsAre(0, testing::DoubleNear(0.02, 1e-15)));
  EXPECT_EQ(times_of(",t,wx,wy,wz\n0,0.0,1,2,3\n1,0.02,1,2,3\n").column, "t");
  EXPECT_THAT(
      error_in(",wx,wy,wz\n0,1,2,3\n1,1,2,3\n2,1,2,3\n"),
      HasSubstr("its rows are numbered by its first column, but nothing states their rate"));
}

TEST(DerivedTimes, ContinuesCountersThatBeginAnew) {
  EXPECT_THAT(
      times_of("# Update Rate: 50 Hz\nPacketCounter,wx,wy,wz\n65535,1,2,3\n0,1,2,3\n").times,
      ElementsAre(0, testing::DoubleNear(0.02, 1e-12)));
  EXPECT_THAT(times_of("SampleTimeFine,wx,wy,wz\n4294967200,1,2,3\n104,1,2,3\n304,1,2,3\n").times,
              ElementsAre(0, testing::DoubleNear(0.02, 1e-12), testing::DoubleNear(0.04, 1e-12)));
  EXPECT_THAT(error_in("SampleTimeFine,wx,wy,wz\n1000,1,2,3\n800,1,2,3\n"),
              HasSubstr("is before that of the row before"));
}

}  // namespace
}  // namespace twrench::recording
