#include "interchange/key_times.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twrench::interchange {
namespace {

// A constant acceleration a needs keys sqrt(8 angle / a) apart.
TEST(KeyTimes, OfAConstantAccelerationAreEvenlySpaced) {
  const auto times = key_times(10, 1e-3, [](double, double) { return RateBounds{0, 0.5}; });
  const double expected = std::sqrt(8 * 1e-3 / 0.5);
  EXPECT_NEAR(static_cast<double>(times.size()), 10 / expected, 3);
  EXPECT_NEAR(times[5] - times[4], expected, 0.01 * expected);
}

// However large the angle, the player must take the short way from key to key.
TEST(KeyTimes, AreLessThanAHalfTurnApart) {
  const auto times = key_times(100, 10, [](double, double) { return RateBounds{2, 0}; });
  EXPECT_GE(times.size(), 200U);
  EXPECT_LE(times.size(), 203U);
}

TEST(KeyTimes, AreWhereTheAccelerationIs) {
  const auto bounds = [](double begin, double end) {
    return RateBounds{0, end > 5 && begin < 6 ? 1.0 : 0.0};
  };
  const auto times = key_times(10, 1e-4, bounds);
  int within = 0;
  for (const float time : times) within += time > 5 && time < 6 ? 1 : 0;
  EXPECT_GT(within, 33);
  EXPECT_LT(times.size() - static_cast<std::size_t>(within), 50U);
}

}  // namespace
}  // namespace twrench::interchange
