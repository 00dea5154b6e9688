#include "recording/time_choice.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "recording/columns/open_conventions.h"
#include "recording/conventions/units.h"
#include "table/reader.h"

namespace twrench::recording {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// The time and its unit in each remaining convention: "time in ms"; "time" without a unit.
std::vector<std::string> times_in(const std::string& csv, const Convention& given = {}) {
  const Recording recording(table::open_table("run.csv", csv));
  std::vector<std::string> all;
  for (const Convention& one : with_times(recording, conventions(recording.header(), given))) {
    all.push_back(one.columns.at("t"));
    if (one.time_unit) all.back() += std::string(" in ") + name_of(*one.time_unit).option;
  }
  return all;
}

/// Rows with these cells as times, written by `times(i)`.
std::string csv_with(const std::string& names, const std::function<std::string(long)>& times) {
  std::string csv = names + ",wx,wy,wz\n";
  for (long i = 0; i < 8; ++i) csv += times(i) + ",0.1,2,0.3\n";
  return csv;
}

std::vector<std::string> units_from(const std::string& name, long first, long step) {
  return times_in(csv_with(name, [&](long i) { return fmt::format("{}", first + i * step); }));
}

TEST(TimeChoice, DerivesTheUnitOfWholeNumbers) {
  EXPECT_THAT(units_from("timestamp", 12345678, 20000), ElementsAre("timestamp in us"));
  EXPECT_THAT(units_from("timestamp", 1700000000000000000, 20000000),
              ElementsAre("timestamp in ns"));
  EXPECT_THAT(units_from("time", 1700000000000000, 20000), ElementsAre("time in us"));
  EXPECT_THAT(units_from("time", 1700000000000, 20), ElementsAre("time in ms"));
  EXPECT_THAT(units_from("epoch", 1700000000, 1), ElementsAre("epoch in s"));
  EXPECT_THAT(units_from("stamp", 0, 5000000), ElementsAre("stamp in ns"));
}

TEST(TimeChoice, LeavesUnitsOpenThatTheNumbersAllow) {
  EXPECT_THAT(units_from("timestamp", 0, 20), ElementsAre("timestamp in s", "timestamp in ms"));
  EXPECT_THAT(units_from("timestamp", 0, 1000), ElementsAre("timestamp in ms", "timestamp in us"));
  EXPECT_THAT(units_from("stamp", 0, 1000), ElementsAre("stamp in ms", "stamp in us"));
}

TEST(TimeChoice, KeepsSecondsAndStatedUnits) {
  EXPECT_THAT(units_from("t", 0, 20), ElementsAre("t"));
  EXPECT_THAT(units_from("time", 0, 86400), ElementsAre("time"));  // as of a slow asteroid
  EXPECT_THAT(units_from("time_ms", 0, 20000), ElementsAre("time_ms in ms"));
  EXPECT_THAT(times_in(csv_with("stamp", [](long i) { return fmt::format("{}.5", i); })),
              ElementsAre("stamp"));
  Convention given;
  given.time_unit = TimeUnit::ms;
  EXPECT_THAT(
      times_in(csv_with("stamp", [](long i) { return fmt::format("{}", 20000 * i); }), given),
      ElementsAre("stamp in ms"));
}

TEST(TimeChoice, ReadsTheClockOfXsens) {
  EXPECT_THAT(units_from("SampleTimeFine", 7, 200), ElementsAre("SampleTimeFine in 0.1ms"));
  EXPECT_THAT(units_from("SampleTimeFine", 7, 16667), ElementsAre("SampleTimeFine in us"));
}

TEST(TimeChoice, ReadsTheClockOfBetaflight) {
  EXPECT_THAT(times_in(csv_with("loopIteration,time",
                                [](long i) { return fmt::format("{},{}", i, 20000 * i); })),
              ElementsAre("time in us"));
}

TEST(TimeChoice, TakesOneOfTimesThatAgree) {
  EXPECT_THAT(times_in(csv_with("seconds_elapsed,time",
                                [](long i) {
                                  return fmt::format("{:.3f},{}",
                                                     0.137 + 0.02 * static_cast<double>(i),
                                                     1700000000000000000 + i * 20000000);
                                })),
              ElementsAre("time in ns"));
  // That of the sample rather than that of the message.
  EXPECT_THAT(times_in(csv_with("time,field.header.stamp",
                                [](long i) {
                                  return fmt::format("{},{}",
                                                     1700000000000000000 + i * 20000000 + i % 3,
                                                     1700000000000000000 + i * 20000000);
                                })),
              ElementsAre("field.header.stamp in ns"));
  // One that does not increase is none.
  EXPECT_THAT(times_in(csv_with("timestamp,timestamp_sample",
                                [](long i) { return fmt::format("{},0", i * 20000); })),
              ElementsAre("timestamp in us"));
}

TEST(TimeChoice, LeavesTimesOpenThatDisagree) {
  EXPECT_THAT(times_in(csv_with("time,elapsed",
                                [](long i) { return fmt::format("{}.5,{}.25", i, i + i * i); })),
              UnorderedElementsAre("time", "elapsed"));
}

}  // namespace
}  // namespace twrench::recording
