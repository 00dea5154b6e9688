#include "sound/motion_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sound/synthesizer.h"

namespace twrench::sound {
namespace {

std::vector<float> samples_of(const MotionTrack& track, double begin, double end) {
  std::vector<float> all;
  track.play(begin, end, [&](std::span<const float> samples) {
    all.insert(all.end(), samples.begin(), samples.end());
    return true;
  });
  return all;
}

/// A film of that many seconds of a box with these edges in cm, which turns `turns` rad per second
/// of film.
scene::Scene film(double seconds, double turns = 6, const std::string& size = "8, 3, 1") {
  return scene::parse_scene("[[part]]\nshape = \"box\"\nsize = [" + size +
                                "]\ndensity = 1\n[motion]\nomega = [0.001, 1, 0]\nduration = " +
                                std::to_string(seconds * turns) +
                                "\n[film]\nfps = 30\nspeed = " + std::to_string(turns) + "\n",
                            "test.toml");
}

double loudness_of(const std::vector<float>& samples) {
  return loudness([&](const Sink& sink) { sink(samples); });
}

float peak_of(const std::vector<float>& samples) {
  return std::abs(*std::ranges::max_element(samples, {}, [](float x) { return std::abs(x); }));
}

TEST(MotionTrack, HasTheLoudnessAndDoesNotClip) {
  for (const double seconds : {0.1, 0.4, 1.0, 12.0}) {
    for (const double turns : {0.01, 6.0, 500.0}) {
      const std::vector<float> samples = samples_of(MotionTrack(film(seconds, turns)), 0, seconds);
      EXPECT_EQ(samples.size(), channels * std::size_t(std::lround(seconds * sample_rate)));
      EXPECT_LT(peak_of(samples), 0.71F) << seconds << " s, " << turns;
      if (seconds < 0.4) continue;
      EXPECT_NEAR(loudness_of(samples), -16, 0.3) << seconds << " s, " << turns;
    }
  }
}

TEST(MotionTrack, IsTheSameForEverySizeOfTheBody) {
  const std::vector<float> samples = samples_of(MotionTrack(film(2)), 0, 2);
  for (const char* size : {"8e-6, 3e-6, 1e-6", "8e5, 3e5, 1e5"}) {
    const std::vector<float> other = samples_of(MotionTrack(film(2, 6, size)), 0, 2);
    ASSERT_EQ(other.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) ASSERT_NEAR(other[i], samples[i], 1e-3);
  }
}

TEST(MotionTrack, OfAPartIsThatPartOfTheWhole) {
  const MotionTrack track(film(4));
  const std::vector<float> whole = samples_of(track, 0, 4), part = samples_of(track, 1.25, 3);
  const auto begin = whole.begin() + channels * 60'000;
  EXPECT_EQ(part, std::vector<float>(begin, begin + channels * 84'000));
}

TEST(MotionTrack, EndsWhenItsSinkIsFull) {
  int pieces = 0;
  MotionTrack(film(4)).play(0, 4, [&](std::span<const float>) { return ++pieces < 3; });
  EXPECT_EQ(pieces, 3);
}

TEST(MotionTrack, IsSilentIfNothingMoves) {
  scene::Scene still = film(1);
  still.camera.frame = scene::Frame::body;
  still.motion.omega = {0, 1, 0};
  const std::vector<float> samples = samples_of(MotionTrack(still), 0, 1);
  EXPECT_EQ(samples.size(), channels * std::size_t{sample_rate});
  EXPECT_EQ(peak_of(samples), 0);
}

TEST(MotionTrack, HasNoClicks) {
  // At the cuts the body stops from a fast turn, and starts again.
  const scene::Scene cut = scene::parse_scene(
      "[[part]]\nshape = \"box\"\nsize = [8, 3, 1]\ndensity = 1\n[motion]\nomega = [0, 0, 1]\n"
      "[[shot]]\nlength = 1\nspeed = 20\n[[shot]]\nlength = 1\nspeed = 0\n"
      "[[shot]]\nlength = 1\nspeed = 20\n",
      "test.toml");
  const std::vector<float> samples = samples_of(MotionTrack(cut), 0, 3);
  const auto steepest = [&](double begin, double end) {
    float most = 0;
    for (auto i = std::size_t(2 * sample_rate * begin); i < std::size_t(2 * sample_rate * end);
         ++i) {
      most = std::max(most, std::abs(samples[i + 2] - samples[i]));
    }
    return most;
  };
  const float usual = 1.5F * steepest(0.2, 0.9);
  EXPECT_GT(usual, 0.01);
  EXPECT_LT(steepest(0.98, 1.1), usual);
  EXPECT_LT(steepest(1.95, 2.1), usual);
  EXPECT_LT(std::abs(samples[0]), 1e-3);
  EXPECT_LT(std::abs(samples[samples.size() - 1]), 1e-3);
  EXPECT_LT(peak_of({samples.begin() + 2 * 72'000, samples.begin() + 2 * 90'000}), 0.03F);
}

}  // namespace
}  // namespace twrench::sound
