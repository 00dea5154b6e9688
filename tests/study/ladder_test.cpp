#include "study/ladder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twrench::study {
namespace {

TEST(StepLadder, BeginsWithARoundStepOfAFifthOfARadian) {
  const std::vector<double> steps = step_ladder(96, 1.00125);
  ASSERT_EQ(steps.size(), 8U);
  EXPECT_DOUBLE_EQ(steps[0], 0.2);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_DOUBLE_EQ(steps[i], steps[i - 1] / 2);
  EXPECT_DOUBLE_EQ(step_ladder(96, 15)[0], 0.01);
}

TEST(StepLadder, LeavesAShortMotionFourSteps) { EXPECT_DOUBLE_EQ(step_ladder(0.1, 1)[0], 0.02); }

TEST(StepLadder, TakesAtMostTwoHundredThousandSteps) {
  EXPECT_GE(step_ladder(10'000, 1).back(), 10'000 / 200'000.0);
  EXPECT_EQ(step_ladder(1e9, 1).size(), 1U);
}

TEST(StepLadder, HasStepsForABodyAtRest) { EXPECT_GT(step_ladder(10, 0).back(), 0); }

TEST(EarlyTime, IsTenRadiansOrTheEnd) {
  EXPECT_DOUBLE_EQ(early_time(96, 1.00125), 10);
  EXPECT_DOUBLE_EQ(early_time(96, 100), 0.1);
  EXPECT_DOUBLE_EQ(early_time(3, 1), 3);
  EXPECT_DOUBLE_EQ(early_time(3, 0), 3);
}

TEST(Median, OfOddAndEvenCounts) {
  EXPECT_EQ(median({5}), 5);
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({9, 1, 5, 6}), 5.5);
}

TEST(FittedExponent, OfAPowerLawWithAStrayPoint) {
  std::vector<PowerLawPoint> points;
  for (const double h : {0.4, 0.2, 0.1, 0.05, 0.025, 0.0125}) {
    points.push_back({h, 7 * std::pow(h, 3)});
  }
  points.back().y *= 100;  // such as from round-off
  EXPECT_NEAR(fitted_exponent(points).value(), 3, 1e-12);
}

TEST(FittedExponent, NeedsTwoPoints) {
  EXPECT_FALSE(fitted_exponent({}));
  const std::vector<PowerLawPoint> one{{1, 1}}, same_step{{1, 1}, {1, 2}};
  EXPECT_FALSE(fitted_exponent(one));
  EXPECT_FALSE(fitted_exponent(same_step));
}

}  // namespace
}  // namespace twrench::study
