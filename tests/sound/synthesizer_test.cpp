#include "sound/synthesizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace twrench::sound {
namespace {

/// A second of a course that is at rest and does not lean.
MotionCourse course_at_rest() {
  return {.length = 1,
          .rate = 10,
          .speeds = std::vector<float>(11, 0),
          .leans = std::vector<float>(11, 0),
          .flips = {}};
}

/// The number of times at which the left channel changes its sign.
int crossings(const MotionCourse& course) {
  std::vector<float> samples(channels * std::size_t{sample_rate});
  Synthesizer(course).synthesize(samples);
  int count = 0;
  for (std::size_t i = channels; i < samples.size(); i += channels) {
    if (samples[i] * samples[i - channels] < 0) ++count;
  }
  return count;
}

TEST(Synthesizer, RaisesThePitchOfABodyThatLeans) {
  MotionCourse course = course_at_rest();
  std::ranges::fill(course.speeds, 1.0F);
  const int upright = crossings(course);
  std::ranges::fill(course.leans, 1.5707F);
  EXPECT_NEAR(crossings(course) / double(upright), 2, 0.15) << "an octave";
}

// At rest for half a second, then of one speed.
TEST(Synthesizer, FollowsTheSpeedsOfTheCourse) {
  MotionCourse course = course_at_rest();
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
  EXPECT_GT(loudest(0.1, 0.5), 0) << "the tone of the room";
  EXPECT_LT(loudest(0.1, 0.5), 0.15 * loudest(0.6, 0.8));
  EXPECT_GT(loudest(0.5, 0.55), loudest(0.1, 0.5)) << "it rises towards the next speed";
  EXPECT_GT(loudest(0.6, 0.8), 2 * loudest(0.5, 0.53));
}

}  // namespace
}  // namespace twrench::sound
