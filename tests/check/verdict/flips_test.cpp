#include "check/verdict/flips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "check/recordings.h"

namespace twrench::check {
namespace {

using recording::Row;

using Eigen::Vector3d;
using testing::ElementsAre;

Reference reference() { return {tumbling_body(), 0}; }

std::vector<SignChange> flips_in(const std::vector<Row>& rows) {
  FlipFinder finder(reference());
  for (const Row& row : rows) finder.add(row.t, row.omega);
  return finder.finish();
}

TEST(FlipFinder, FindsTheExactTimesBetweenRowsFarApart) {
  const std::vector<SignChange> found = flips_in(exact_rows(101, 1.3));
  const std::vector<double> exact = motion::ExactMotion(tumbling_body()).flip_times(130);
  ASSERT_EQ(found.size(), exact.size());
  ASSERT_GE(found.size(), 10U);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i].t, exact[i], 1e-11);
}

TEST(FlipFinder, DoesNotCountNoiseAboutZero) {
  std::vector<Row> rows = exact_rows(20'001, 0.002);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.005);
  for (Row& row : rows) row.omega[1] += noise(random);
  const std::vector<SignChange> found = flips_in(rows);
  const std::vector<double> exact = motion::ExactMotion(tumbling_body()).flip_times(40);
  ASSERT_EQ(found.size(), exact.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i].t, exact[i], 0.05);
}

TEST(FlipFinder, FindsOneAtTheEnd) {
  std::vector<Row> rows = exact_rows(4001, 0.01);
  const double flip = motion::ExactMotion(tumbling_body()).flip_times(40)[2];
  std::erase_if(rows, [&](const Row& row) { return row.t > flip + 0.011; });
  EXPECT_EQ(flips_in(rows).size(), 3U);
}

TEST(ExactFlips, AreCountedOnTheFilesClockAndAlternate) {
  Reference at_five = reference();
  at_five.start = 5;
  const std::vector<double> exact = motion::ExactMotion(tumbling_body()).flip_times(40);
  const std::vector<SignChange> flips = exact_flips(at_five, 5, 45);
  ASSERT_EQ(flips.size(), exact.size());
  const motion::ExactMotion motion(tumbling_body());
  for (std::size_t i = 0; i < flips.size(); ++i) {
    EXPECT_NEAR(flips[i].t, exact[i] + 5, 1e-12);
    EXPECT_EQ(flips[i].up, motion.at(exact[i] + 0.01).omega[1] > 0);
  }
}

TEST(ExactFlips, AreThereBeforeTheStartToo) {
  const motion::ExactMotion motion(tumbling_body());
  const std::vector<SignChange> flips = exact_flips(reference(), -30, 0);
  ASSERT_GT(flips.size(), 2U);
  for (const SignChange& flip : flips) {
    EXPECT_LT(std::abs(motion.at(flip.t).omega[1]), 1e-12);
    EXPECT_EQ(motion.at(flip.t + 0.01).omega[1] > 0, flip.up);
  }
}

TEST(Paired, FlipsGoByTheirNumberAndDirection) {
  const auto pairs =
      paired({{2, false}, {3, true}}, {{1, true}, {2.5, false}, {9, true}, {11, false}});
  ASSERT_EQ(pairs.size(), 4U);
  EXPECT_FALSE(pairs[0].found);
  EXPECT_EQ(pairs[1].found, 2);
  EXPECT_EQ(pairs[1].exact, 2.5);
  EXPECT_EQ(pairs[2].exact, 9);
  EXPECT_FALSE(pairs[3].found);
}

TEST(Paired, FlipsThatTheExactMotionHasNot) {
  const auto pairs = paired({{2, false}}, {});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_FALSE(pairs[0].exact);
}

}  // namespace
}  // namespace twrench::check
