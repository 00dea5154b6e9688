#include "check/verdict/free_flight.h"

#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

namespace twrench::check {
namespace {

using Eigen::Vector3d;
using recording::Row;

constexpr double release = 0.8, caught = 2.0, end = 2.6;  // s

/// The rates of a phone that a hand turns, tosses and catches, at 200 Hz with noise.
std::vector<Row> toss(unsigned seed, const Vector3d& omega) {
  std::mt19937 dice(seed);
  std::normal_distribution noise(0.0, 0.02);
  const motion::ExactMotion flight({Vector3d(225.6, 52.5, 276.8).asDiagonal(), omega});
  std::vector<Row> rows(520);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = static_cast<double>(i) / 200;
    const double hand = std::clamp(std::min(t / release, (end - t) / (end - caught)), 0.0, 1.0);
    rows[i].t = t;
    rows[i].omega = hand * flight.at(std::clamp(t - release, 0.0, caught - release)).omega;
    for (double& rate : rows[i].omega) rate += noise(dice);
  }
  return rows;
}

TEST(FreeFlight, IsFoundBetweenTheHandAndTheCatch) {
  int wrong = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Vector3d omega(7 + 0.2 * seed, seed % 2 == 0 ? 0.3 : -0.2, 0.1 + 0.02 * seed);
    const auto found = free_flight(toss(seed, omega));
    constexpr double near = 0.045;  // a sixtieth of the rows
    const bool is_right =
        found && std::abs(found->from - release) < near && std::abs(found->to - caught) < near;
    wrong += is_right ? 0 : 1;
  }
  EXPECT_LE(wrong, 1);
}

TEST(FreeFlight, IsNotFoundInTheHandAlone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<Row> rows = toss(seed, {7, 0.3, 0.2});
    EXPECT_FALSE(free_flight(std::span(rows).first(160))) << seed;
  }
}

TEST(FreeFlight, OfAllRowsIsNoPart) {
  const std::vector<Row> rows = toss(3, {7, 0.3, 0.2});
  EXPECT_FALSE(free_flight(std::span(rows).subspan(160, 240)));
  EXPECT_FALSE(free_flight(std::span(rows).first(3)));
  EXPECT_FALSE(free_flight({}));
}

}  // namespace
}  // namespace twrench::check
