#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/twrench.h"

namespace twrench {
namespace {

using nlohmann::json;
using testing::StartsWith;

constexpr const char* header =
    "t,x11,x12,x13,x21,x22,x23,x31,x32,x33,wx,wy,wz,energy,energy_drift,orthogonality_error,"
    "momentum_error\n";

/// The numbers of a CSV text below its header.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv.substr(csv.find('\n') + 1));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

TEST(Simulate, CsvAtExactlyTheTimesAskedFor) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "simulate --times 0,0.3,7.25,-2");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith(header));
  const auto rows = rows_of(run.out);
  ASSERT_EQ(rows.size(), 4u);
  const double times[] = {0, 0.3, 7.25, -2};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(rows[i].size(), 17u);
    EXPECT_EQ(rows[i][0], times[i]);
  }
  EXPECT_EQ(rows[0][1], 1);
  EXPECT_DOUBLE_EQ(rows[0][11], 0.05);
}

TEST(Simulate, FromZeroToTheDurationBothIncluded) {
  const ScratchFolder folder;
  const auto rows = rows_of(run_twrench(folder, "simulate --duration 2 --fps 10").out);
  ASSERT_EQ(rows.size(), 21u);
  EXPECT_EQ(rows.front()[0], 0);
  EXPECT_EQ(rows[7][0], 7 / 10.0);
  EXPECT_EQ(rows.back()[0], 2);
  const auto odd = rows_of(run_twrench(folder, "simulate --duration 1.05 --fps 10").out);
  ASSERT_EQ(odd.size(), 12u);
  EXPECT_EQ(odd.back()[0], 1.05);
}

// 4560 / 0.0006 is rounded up, 4559.9... samples would be rounded down.
TEST(Simulate, EndsAtTheDurationWhateverTheRoundingOfTheRate) {
  const ScratchFolder folder;
  for (const char* times : {"--duration 7600000 --fps 0.0006", "--duration 4.35 --fps 100"}) {
    const Outcome run = run_twrench(folder, std::string("simulate --method exact ") + times);
    ASSERT_EQ(run.code, 0) << run.err;
    const auto rows = rows_of(run.out);
    EXPECT_EQ(rows.back()[0], std::atof(times + sizeof("--duration")));
    const double before = rows[rows.size() - 2][0], step = rows[1][0];
    EXPECT_NEAR(rows.back()[0] - before, step, 1e-6 * step) << times;
  }
}

TEST(Simulate, DescribesItsMethodCorrectly) {
  const ScratchFolder folder;
  const auto rows =
      rows_of(run_twrench(folder, "simulate --method euler --step 0.01 --times 10").out);
  EXPECT_GT(std::abs(rows[0][14]), 1e-3);  // energy drift
  EXPECT_GT(rows[0][15], 1e-3);            // it left SO(3)
}

TEST(Simulate, JsonHasTheSameNumbers) {
  const ScratchFolder folder;
  const auto row = rows_of(run_twrench(folder, "simulate stable-y --times 3").out)[0];
  const json document =
      json::parse(run_twrench(folder, "simulate stable-y --times 3 --format json").out);
  const json& sample = document["samples"][0];
  EXPECT_EQ(sample["t"], row[0]);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(sample["X"][i], row[1 + i]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(sample["omega"][i], row[10 + i]);
  EXPECT_EQ(sample["energy"], row[13]);
}

// The document is written sample by sample, but must match the output of the JSON library.
TEST(Simulate, WritesNoNegativeZero) {
  const ScratchFolder folder;
  const std::string command = "simulate sphere --method exact --times 1,10,100 --format ";
  EXPECT_EQ(run_twrench(folder, command + "csv").out.find("-0,"), std::string::npos);
  EXPECT_EQ(run_twrench(folder, command + "json").out.find("-0.0,"), std::string::npos);
}

TEST(Simulate, JsonIsTheLibrarysOwnText) {
  const ScratchFolder folder;
  for (const char* times : {"", " --times 2", " --times 2,-1"}) {
    const std::string text =
        run_twrench(folder, std::string("simulate --duration 1 --fps 7 --format json") + times).out;
    EXPECT_EQ(nlohmann::ordered_json::parse(text).dump(1) + "\n", text);
  }
}

#if !defined(TWRENCH_SANITIZED)  // sanitizers keep freed memory
/// The peak memory of simulating that number of samples, kB.
long peak_memory(int samples, const std::string& format) {
  const ScratchFolder folder;
  const Outcome run = run_twrench(folder, "simulate --method exact --fps 1000 --duration " +
                                              std::to_string(samples / 1000) + " --format " +
                                              format + " -o /dev/null");
  EXPECT_EQ(run.code, 0) << run.err;
  return run.peak_memory;
}

// The peak does not grow with the number of samples. The size of the libraries and the number of
// threads contribute the same to both runs.
TEST(Simulate, KeepsAtMostABlockOfSamples) {
  constexpr int few = 20'000, many = 120'000;
  constexpr long bytes_of_a_sample = 13 * 8;  // t, X and omega, the least that could be kept
  constexpr long kept = (many - few) * bytes_of_a_sample / 1024;
  for (const char* format : {"csv", "json"}) {
    EXPECT_LT(peak_memory(many, format), peak_memory(few, format) + kept / 2) << format;
  }
}
#endif

TEST(Simulate, ANameThatIsNoUtf8IsWrittenAsJsonCan) {
  const ScratchFolder folder;
  system::write_file_atomically(folder / "a\xff.toml", "[body]\nmoments = [1, 2, 3]\n");
  for (const char* command : {"simulate --times 1", "inertia", "study --methods exact"}) {
    const Outcome run = run_twrench(folder, std::string(command) + " --format json a*.toml");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["scene"], "a\uFFFD") << command;
  }
}

TEST(Simulate, WritesAFileWholeOrNotAtAll) {
  const ScratchFolder folder;
  EXPECT_EQ(run_twrench(folder, "simulate --times 1 -o a.csv").code, 0);
  EXPECT_THAT(text_of(folder / "a.csv"), StartsWith(header));
  EXPECT_EQ(run_twrench(folder, "simulate --times 1 -o no/such/folder.csv").code, 5);
}

TEST(Simulate, AnswersInPointsWhateverTheLocale) {
  const ScratchFolder folder;
  const std::string plain = run_twrench(folder, "simulate --times 1.5").out;
  EXPECT_EQ(run_twrench(folder, "simulate --times 1.5", "LC_ALL=de_DE.UTF-8 ").out, plain);
}

}  // namespace
}  // namespace twrench
