#include "sound/synthesizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sound/sample_rate.h"

namespace twrench::sound {
namespace {

// At rest for half a second, then of one speed.
TEST(Synthesizer, FollowsTheSpeedsOfTheCourse) {
  MotionCourse course{.length = 1, .rate = 10, .speeds = std::vector<float>(11, 0), .flips = {}};
  constexpr std::size_t first = 6;  // the first speed that is not 0
  std::fill(course.speeds.begin() + first, course.speeds.end(), 4.0F);
  std::vector<float> samples(channels * std::size_t{sample_rate});
  Synthesizer(course).synthesize(samples);
  const auto loudest = [&](double begin, double end) {
    const auto at = [&](double time) {
      return samples.begin() + channels * std::lround(time * sample_rate);
    };
    return std::abs(*std::max_element(at(begin), at(end),
                                      [](float a, float b) { return std::abs(a) < std::abs(b); }));
  };
  EXPECT_EQ(loudest(0, 0.5), 0);
  EXPECT_GT(loudest(0.5, 0.55), 0) << "it rises towards the next speed";
  EXPECT_GT(loudest(0.6, 0.8), 2 * loudest(0.5, 0.53));
}

}  // namespace
}  // namespace twrench::sound
