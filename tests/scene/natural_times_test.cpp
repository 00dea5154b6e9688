#include "scene/natural_times.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <cmath>
#include <string>

#include "scene/scene_values.h"

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
  for (const double push : {0.4, 0.05, 1e-3, 1e-8, 1e-100}) {
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
  // A symmetric body in whose frame the momentum circles in 2 pi / (0.5 cos(0.2)) s.
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

TEST(NaturalTimes, SuitAllMotionsThatAreShownSideBySide) {
  const std::string body = "[body]\nmoments = [3, 5, 7]\n";
  const Scene both =
      parse_scene(body + "[overlay]\ncompare_omega = [[0.05, 1, 0], [0, 0, 20]]\n", "both.toml");
  const Scene slow = parse_scene(body + "[motion]\nomega = [0.05, 1, 0]\n", "slow.toml");
  const Scene fast = parse_scene(body + "[motion]\nomega = [0, 0, 20]\n", "fast.toml");
  EXPECT_EQ(both.motion.duration, slow.motion.duration);
  EXPECT_EQ(both.film.speed, slow.film.speed);
  EXPECT_EQ(both.motion.control.step, fast.motion.control.step);
  EXPECT_EQ(sample_rate(both), sample_rate(fast));
}

constexpr const char* body_and_motion =
    "[body]\nmoments = [3, 5, 7]\n[motion]\nomega = [0, 2e-5, 1e-6]\n";

TEST(NaturalTimes, ApplyWhereAFileGivesNone) {
  const Scene scene = parse_scene(body_and_motion, "own.toml");
  const NaturalTimes times = natural_times(scene);
  EXPECT_EQ(scene.motion.control.step, times.step);
  EXPECT_EQ(scene.motion.duration, times.duration);
  EXPECT_EQ(scene.film.speed, times.speed);
  EXPECT_EQ(scene.film.fps, 60);
  EXPECT_EQ(sample_rate(scene), times.sample_rate);
  const Scene given = parse_scene(
      std::string(body_and_motion) + "step = 3\nduration = 4\n[film]\nspeed = 5\nfps = 6\n",
      "own.toml");
  EXPECT_EQ(given.motion.control.step, 3);
  EXPECT_EQ(given.motion.duration, 4);
  EXPECT_EQ(given.film.speed, 5);
  EXPECT_EQ(given.film.fps, 6);
}

TEST(NaturalTimes, GiveEachShotItsOwnStepAndSpeed) {
  const Scene film = parse_scene(std::string(body_and_motion) +
                                     "[[shot]]\nlength = 5\n[[shot]]\nlength = 5\n"
                                     "[shot.motion]\nomega = [0, 2e5, 1e4]\n",
                                 "film.toml");
  for (const Shot& shot : film.shots) {
    const NaturalTimes times = natural_times(shot.scene);
    EXPECT_EQ(shot.scene.motion.control.step, times.step);
    EXPECT_EQ(shot.scene.film.speed, times.speed);
    EXPECT_EQ(shot.scene.motion.duration, 5 * times.speed);
  }
}

TEST(SampleRate, IsTheFrameRateOfASceneIfThatSuitsTheMotion) {
  Scene scene = load_scene("dzhanibekov");
  EXPECT_EQ(sample_rate(scene), 60);
  scene.film.fps = 0.1;  // 0.6 a turn
  EXPECT_EQ(sample_rate(scene), 60);
  scene.film.fps = 1000;
  EXPECT_EQ(sample_rate(scene), 1000);
  scene.motion.duration = 1e5;  // 10^8 samples
  EXPECT_EQ(sample_rate(scene), 60);
  scene.origins.fps = Origin::user;
  EXPECT_EQ(sample_rate(scene), 1000);
}

TEST(ReplaceBody, TakesWhatWasSaidOfTheOtherBodyWithIt) {
  Scene scene = load_scene("toutatis");
  Body body;
  body.inertia = Vector3d(3, 5, 7).asDiagonal();
  replace_body(scene, body);
  set_natural_times(scene);
  EXPECT_EQ(scene.title, "A free rigid body");
  EXPECT_FALSE(scene.overlay.trail_length);
  EXPECT_FALSE(scene.overlay.trail_point);
  EXPECT_EQ(scene.motion.duration, natural_times(scene).duration);
  EXPECT_EQ(scene.film.speed, natural_times(scene).speed);
}

// Times and title follow from the motion, whichever axes the inertia is given about.
TEST(ReplaceBody, GivesTheSameBodyInOtherAxesTheSameTimes) {
  const Eigen::Matrix3d moments = Vector3d(3, 5, 7).asDiagonal();
  const Eigen::Matrix3d R = so3::exp(Vector3d(0.4, -1, 0.7));
  const Eigen::Matrix3d turned = R * moments * R.transpose();
  const auto scene_of = [](const Eigen::Matrix3d& inertia, const Vector3d& omega) {
    Scene scene = load_scene("toutatis");
    scene.motion.omega = omega;
    set_body(scene, {{}, inertia});
    return scene;
  };
  const Scene straight = scene_of(moments, {0.05, 1, 0.02});
  const Scene other = scene_of((turned + turned.transpose()) / 2, R * Vector3d(0.05, 1, 0.02));
  EXPECT_EQ(other.title, "A free rigid body");
  EXPECT_EQ(other.motion.duration, straight.motion.duration);
  EXPECT_EQ(other.motion.control.step, straight.motion.control.step);
  EXPECT_EQ(other.film.speed, straight.film.speed);
  EXPECT_EQ(sample_rate(other), sample_rate(straight));
  EXPECT_NE(scene_of(moments, R * Vector3d(0.05, 1, 0.02)).motion.duration,
            straight.motion.duration);
}

TEST(ReplaceBody, LeavesWhatTheUserGave) {
  Scene scene = load_scene("toutatis");
  scene.title = "Mine";
  scene.motion.duration = 5;
  scene.origins.title = scene.origins.duration = Origin::user;
  Body body;
  body.inertia = Vector3d(3, 5, 7).asDiagonal();
  replace_body(scene, body);
  set_natural_times(scene);
  EXPECT_EQ(scene.title, "Mine");
  EXPECT_EQ(scene.motion.duration, 5);
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

TEST(NaturalTimes, ResolveTheFastFlipsOfImpossibleMoments) {
  // A turn about the intermediate axis takes 6.28 s, but the body turns at 1000 rad/s in a flip.
  const NaturalTimes times = times_of({1e-6, 1, 1e6}, {1e-3, 1, 0});
  EXPECT_LT(times.step, 1e-4);
  EXPECT_EQ(flips_of({1e-6, 1, 1e6}, {1e-3, 1, 0}), 3U);
}

}  // namespace
}  // namespace twrench::scene
