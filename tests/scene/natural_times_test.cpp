#include "scene/natural_times.h"

#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <cmath>

namespace twrench::scene {
namespace {

using Eigen::Vector3d;

NaturalTimes times_of(const Vector3d& moments, const Vector3d& omega) {
  return natural_times(motion::FreeBody(moments.asDiagonal(), omega));
}

std::size_t flips_of(const Vector3d& moments, const Vector3d& omega) {
  const motion::ExactMotion motion(motion::FreeBody(moments.asDiagonal(), omega));
  return motion.flip_times(times_of(moments, omega).duration).size();
}

TEST(NaturalTimes, OfTheTWrenchAreItsBuiltInValues) {
  for (const char* name : {"dzhanibekov", "calm", "stable-y", "stable-z", "sphere"}) {
    const Scene scene = load_scene(name);
    const NaturalTimes times = natural_times(scene);
    EXPECT_EQ(times.step, scene.motion.control.step) << name;
    EXPECT_EQ(times.sample_rate, scene.film.fps) << name;
    EXPECT_EQ(times.speed, scene.film.speed) << name;
  }
}

TEST(NaturalTimes, LastThreeFlips) {
  for (const double push : {0.5, 0.05, 1e-3, 1e-8, 1e-100}) {
    EXPECT_EQ(flips_of({3, 5, 7}, {push, 1, 0}), 3U) << push;
    EXPECT_EQ(flips_of({3, 5, 7}, {0, 1, -push}), 3U) << push;
    EXPECT_EQ(flips_of({1, 100, 100.5}, {push, 1, 0}), 3U) << push;
  }
}

TEST(NaturalTimes, ScaleWithTheMotion) {
  const NaturalTimes one = times_of({3, 5, 7}, {0.05, 1, 0});
  for (const double scale : {1e-9, 1e-3, 1e3, 1e9}) {
    const NaturalTimes times = times_of({3e-20, 5e-20, 7e-20}, Vector3d(0.05, 1, 0) / scale);
    EXPECT_DOUBLE_EQ(times.step, one.step * scale);
    EXPECT_DOUBLE_EQ(times.sample_rate, one.sample_rate / scale);
    EXPECT_DOUBLE_EQ(times.duration, one.duration * scale);
    EXPECT_DOUBLE_EQ(times.speed, one.speed * scale);
  }
}

TEST(NaturalTimes, ShowTheNutationOfABodyThatDoesNotTurnOver) {
  // A symmetric body whose momentum goes round in its frame in 2 pi / (0.5 cos(0.2)) s.
  const NaturalTimes top = times_of({2, 2, 3}, {std::sin(0.2), 0, std::cos(0.2)});
  EXPECT_EQ(top.duration, 100);  // 16 turns are more than three periods of 12.8 s
  const NaturalTimes slow = times_of({10, 10, 11}, {std::sin(0.2), 0, std::cos(0.2)});
  EXPECT_EQ(slow.duration, 190);  // three periods of 64.1 s
  const NaturalTimes slower = times_of({1000, 1000, 1001}, {std::sin(0.2), 0, std::cos(0.2)});
  EXPECT_EQ(slower.duration, 630);  // 100 turns
  EXPECT_EQ(times_of({3, 5, 7}, {0, 0, 1}).duration, 100);
}

TEST(NaturalTimes, OfAMotionThatTurnsOverButOnce) {
  // On the separatrix of (1, 2, 3), w_1^2 = 3 w_3^2: before, in and after the only flip.
  const Vector3d before(std::sqrt(3.0), -2, 1), in(std::sqrt(3.0), 0, 1),
      after(std::sqrt(3.0), 2, 1);
  for (const Vector3d& omega : {before, in, after}) {
    const NaturalTimes times = times_of({1, 2, 3}, omega);
    EXPECT_GT(times.duration, 10 * times.speed);
    EXPECT_LT(times.duration, 61 * times.speed);
  }
}

TEST(NaturalTimes, HaveBounds) {
  // Flips that are more than 1000 turns apart cannot be shown.
  const NaturalTimes rare = times_of({1, 1 + 1e-9, 1 + 2e-9}, {0.05, 1, 0});
  EXPECT_LE(rare.duration, 630);
  EXPECT_EQ(times_of({3, 5, 7}, {0, 0, 0}).step, 0.01);
  for (const double omega : {1e-100, 1e12}) {
    const NaturalTimes times = times_of({3e-60, 5e-60, 7e-60}, {omega / 20, omega, 0});
    EXPECT_TRUE(std::isfinite(times.sample_rate));
    EXPECT_GE(times.step, 1e-15);
    EXPECT_GE(times.duration, 10 * times.speed * 0.9);
  }
}

TEST(NaturalTimes, ResolveTheFastFlipsOfMomentsThatNoBodyHas) {
  // A turn about the intermediate axis takes 6.28 s, but the body turns at 1000 rad/s in a flip.
  const NaturalTimes times = times_of({1e-6, 1, 1e6}, {1e-3, 1, 0});
  EXPECT_LT(times.step, 1e-4);
  EXPECT_EQ(flips_of({1e-6, 1, 1e6}, {1e-3, 1, 0}), 3U);
}

}  // namespace
}  // namespace twrench::scene
