#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plot/plots.h"

namespace twrench::plot {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

check::Span span(double t, double rate_error, double attitude_error) {
  check::Span span{{.t = t}};
  span.rate_error = rate_error;
  span.attitude_error = attitude_error;
  span.rate_limit = 2e-9;
  span.attitude_limit = 3e-9;
  return span;
}

check::Judgement judgement(bool has_rates, bool has_attitude) {
  const motion::FreeBody body(Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, 1));
  recording::Convention convention;
  convention.rate_unit = recording::RateUnit::deg_s;
  return {.convention = convention,
          .has_rates = has_rates,
          .has_attitude = has_attitude,
          .first_time = 5,
          .duration = 2,
          .reference = {body},
          .course = {span(0, 0, 0), span(1, 1e-6, 1e-7), span(2, 2e-5, 2e-7)}};
}

std::string script(const std::vector<JudgedCurve>& curves) { return check_plot(curves).script; }

TEST(CheckPlot, HasAPanelForEachKindOfErrorInItsUnit) {
  const check::Judgement both = judgement(true, true), rates = judgement(true, false);
  EXPECT_THAT(script({{"a", &both}}),
              AllOf(HasSubstr("title 'Rates'"), HasSubstr("title 'Attitude'"),
                    HasSubstr("error (deg/s)"), HasSubstr("[5:7]")));
  EXPECT_THAT(script({{"a", &rates}}), Not(HasSubstr("title 'Attitude'")));
  EXPECT_THAT(script({{"a", &rates}, {"b", &both}}),
              AllOf(HasSubstr("$rates1 using 1:2"), HasSubstr("$attitude1 using 1:2"),
                    Not(HasSubstr("$attitude0"))));
}

TEST(CheckPlot, HasTimesInAUnitThatReadsWell) {
  check::Judgement brief = judgement(true, false);
  EXPECT_THAT(script({{"a", &brief}}), HasSubstr("set xlabel 't (s)'"));
  brief.duration = 2e-8;
  EXPECT_THAT(script({{"a", &brief}}), HasSubstr("set xlabel 't (ns)'"));
  check::Judgement one_row = judgement(true, false);
  one_row.duration = 0;
  EXPECT_THAT(script({{"a", &one_row}}), HasSubstr("set xlabel 't (s)'"));
}

// 2e-5 rad/s is 1.1e-3 deg/s.
TEST(CheckPlot, HoldsAllErrorsAndLimitsAndLeavesZerosOut) {
  const check::Judgement both = judgement(true, true);
  const std::string text = script({{"a", &both}});
  EXPECT_THAT(text,
              AllOf(HasSubstr("5 NaN 1.14592e-07\n"), HasSubstr("7 0.00114592 1.14592e-07\n"),
                    HasSubstr("set yrange [1e-7:1e-2]"), HasSubstr("set yrange [1e-7:1e-4]")));
}

TEST(CheckPlot, TakesAnyNameOfAFile) {
  const check::Judgement rates = judgement(true, false);
  EXPECT_THAT(script({{"a\"_b`.csv", &rates}}),
              HasSubstr("title \"a\\042_b\\140.csv\" noenhanced"));
}

}  // namespace
}  // namespace twrench::plot
