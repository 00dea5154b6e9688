#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <array>
#include <random>
#include <string>

#include "check/report/checked_file.h"
#include "check/report/report.h"
#include "check/verdict/error.h"
#include "recording/columns/open_conventions.h"
#include "sanitizers.h"
#include "scratch_folder.h"
#include "system/file.h"

namespace twrench::check {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

/// The report as text and JSON, or the message of the error.
std::string report_of(const std::string& csv, const Problem& problem) {
  static const ScratchFolder folder;
  const std::filesystem::path file = folder / "run.csv";
  system::write_file_atomically(file, csv);
  try {
    const CheckResult result = check_files(
        1, [&](std::size_t) { return recording::Recording(file); }, {}, {}, problem, {});
    const auto by_name = [](std::string_view name, std::string_view) { return std::string(name); };
    return check_text(result, by_name) + check_json(result, by_name) + check_junit(result, by_name);
  } catch (const Error& error) {
    return std::string("error: ") + error.what();
  }
}

void expect_finite(const std::string& csv, const Problem& problem) {
  EXPECT_THAT(report_of(csv, problem),
              Not(AnyOf(HasSubstr("nan"), HasSubstr(" inf"), HasSubstr("-inf"), HasSubstr(",inf"))))
      << csv;
}

Problem problem_of(const Eigen::Vector3d& moments, bool fit, bool has_omega, bool at_first) {
  Problem problem{.inertia = moments.asDiagonal(), .fit = fit};
  if (has_omega) problem.omega = Eigen::Vector3d(1e-72, 1e-95, 4.9e-324);
  if (at_first) problem.omega_time.reset();
  return problem;
}

const std::array bodies{Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(1e-12, 1, 1),
                        Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 1e12, 1e12)};

/// A number that is at the limits, beyond them, or usual.
std::string number_of(std::mt19937& dice) {
  static constexpr std::array extreme{"1e12", "-1e12",    "1e-90",  "-1e-100", "0",
                                      "-0",   "4.9e-324", "1e-160", "1e-320",  "1e13",
                                      "1",    "1e-9",     "1e6",    "1e154"};
  if (dice() % 3 != 0) return fmt::format("{}", (double(dice()) / double(dice.max()) - 0.5) * 4);
  return extreme[dice() % extreme.size()];
}

// Whether rows are refused or judged, no report has a number that is not finite.
TEST(ExtremeRows, AreRefusedOrJudgedByFiniteNumbers) {
  std::mt19937 dice(7);
  // The later ones differ in their numbers.
  const int tried = has_sanitizers ? 100 : 600;
  for (int count = 0; count < tried; ++count) {
    const bool has_attitude = dice() % 3 == 0;
    std::string csv = has_attitude ? "t,wx,wy,wz,qw,qx,qy,qz\n" : "t,wx,wy,wz\n";
    const int rows = 1 + static_cast<int>(dice() % 12);
    const double step = std::array{0.1, 1e-12, 1e9, 1e-15, 1e14}[dice() % 5];
    const double start = std::array{0.0, -1e12, 1e-160, 1.7e9}[dice() % 4];
    for (int i = 0; i < rows; ++i) {
      csv += fmt::format("{:.17g},{},{},{}", start + i * step, number_of(dice), number_of(dice),
                         number_of(dice));
      csv += has_attitude ? (i % 2 == 0 ? ",1,0,0,0\n" : ",0,0,0.8,0.6\n") : "\n";
    }
    const Problem problem = problem_of(bodies[dice() % bodies.size()], dice() % 2 == 0,
                                       dice() % 4 == 0, dice() % 2 == 0);
    expect_finite(csv, problem);
  }
}

TEST(ExtremeRows, OfABodyThatStartsToTurnHaveNoRelativeDrift) {
  for (const bool fit : {false, true}) {
    expect_finite("t,wx,wy,wz\n0,0,0,0\n1,1,2,3\n2,1,2,3\n3,1,2,3\n",
                  problem_of({2, 3, 4}, fit, false, false));
  }
}

TEST(ExtremeRows, AreNamedWithFileLineAndColumn) {
  const Problem problem = problem_of({2, 3, 4}, true, false, false);
  EXPECT_THAT(report_of("t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n2,1e156,2,3\n3,1,2,3\n", problem),
              HasSubstr("run.csv:4: the column 'wx': 1e+156 rad/s is beyond"));
  EXPECT_THAT(report_of("t,wx,wy,wz\n0,1e160,1,1\n1,1,1,1\n2,1,1,1\n", problem),
              HasSubstr("run.csv:2: the column 'wx': 1e+160 rad/s is beyond"));
}

}  // namespace
}  // namespace twrench::check
