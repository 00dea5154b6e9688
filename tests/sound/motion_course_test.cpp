#include "sound/motion_course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "timeline/timeline.h"

namespace twrench::sound {
namespace {

/// A body with parts that turns over again and again.
std::string scene_of(double size, double unit_of_time) {
  const auto number = [](double value) { return std::to_string(value) + "e-6"; };
  const double length = 1e6 * size, rate = 1e6 / unit_of_time;
  return "[[part]]\nshape = \"box\"\nsize = [" + number(8 * length) + ", " + number(3 * length) +
         ", " + number(length) + "]\ndensity = 1\n[motion]\nomega = [" + number(0.001 * rate) +
         ", " + number(rate) + ", 0]\nduration = " + number(60e6 * unit_of_time) +
         "\n[film]\nfps = 30\nspeed = " + number(6e6 * unit_of_time) + "\n";
}

MotionCourse course_of(const std::string& toml) {
  return motion_course(scene::parse_scene(toml, "test.toml"));
}

void expect_equal(const MotionCourse& a, const MotionCourse& b) {
  EXPECT_NEAR(a.length, b.length, 1e-12);
  ASSERT_EQ(a.speeds.size(), b.speeds.size());
  for (std::size_t i = 0; i < a.speeds.size(); ++i) ASSERT_NEAR(a.speeds[i], b.speeds[i], 1e-3);
  ASSERT_EQ(a.flips.size(), b.flips.size());
  for (std::size_t i = 0; i < a.flips.size(); ++i) ASSERT_NEAR(a.flips[i], b.flips[i], 1e-6);
}

TEST(MotionCourse, DependsNeitherOnTheSizeNorOnTheUnitOfTime) {
  const MotionCourse course = course_of(scene_of(1, 1));
  ASSERT_FALSE(course.flips.empty());
  for (const double size : {1e-6, 1e-3, 1e5}) expect_equal(course, course_of(scene_of(size, 1)));
  for (const double unit : {1e-3, 1e3}) expect_equal(course, course_of(scene_of(1, unit)));
}

TEST(MotionCourse, HasTheSpeedsOfTheEnds) {
  // A bar along x turns about z at 2 rad per second of film. Its two far ends move at 2 radii per
  // second; those along y and z, which are near the axis, at 0.2 and 0.
  const MotionCourse course = course_of(
      "[[part]]\nshape = \"box\"\nsize = [20, 2, 0.02]\ndensity = 1\n[motion]\nomega = [0, 0, 1]\n"
      "duration = 10\n[film]\nspeed = 2\n");
  EXPECT_DOUBLE_EQ(course.length, 5);
  EXPECT_EQ(course.speeds.size(), 500U);
  const double mean = std::sqrt((2 * 2 * 2 + 2 * 0.2 * 0.2) / 6);
  EXPECT_NEAR(course.speeds.front(), mean, 1e-6);
  EXPECT_NEAR(course.speeds.back(), mean, 1e-6);
  EXPECT_TRUE(course.flips.empty());
}

TEST(MotionCourse, IsRelativeToTheCamera) {
  const std::string body =
      "[[part]]\nshape = \"box\"\nsize = [20, 2, 1]\ndensity = 1\n[motion]\nomega = [0, 1, 0]\n"
      "duration = 10\n[film]\nspeed = 2\n[camera]\n";
  EXPECT_NEAR(course_of(body + "frame = \"body\"").speeds[100], 0, 1e-6);
  EXPECT_NEAR(course_of(body + "frame = \"rotating\"").speeds[100], 0, 1e-6);
  // The camera orbits with the body, or against it.
  EXPECT_NEAR(course_of(body + "orbit = 2").speeds[100], 0, 1e-6);
  EXPECT_NEAR(course_of(body + "orbit = -2").speeds[100],
              2 * course_of(body + "orbit = 0").speeds[100], 1e-6);
}

TEST(MotionCourse, FollowsTheCameraToAnotherFrameOfReference) {
  const MotionCourse course = course_of(
      "[[part]]\nshape = \"box\"\nsize = [20, 2, 1]\ndensity = 1\n[motion]\nomega = [0, 1, 0]\n"
      "[film]\nspeed = 2\n[[shot]]\nlength = 3\n"
      "[[shot]]\nlength = 3\nmove = 2\n[shot.camera]\nframe = \"body\"\n");
  const double in_space = course.speeds[100];
  EXPECT_GT(in_space, 1);
  EXPECT_NEAR(course.speeds[300], in_space, 1e-6) << "the camera is still at rest";
  EXPECT_NEAR(course.speeds[400], in_space / 2, 1e-6);
  EXPECT_NEAR(course.speeds[500], 0, 1e-6) << "it turns with the body";
  for (std::size_t i = 1; i < course.speeds.size(); ++i) {
    EXPECT_LT(std::abs(course.speeds[i] - course.speeds[i - 1]), 0.01 * in_space) << i;
  }
}

TEST(MotionCourse, TakesShotsOfEveryLength) {
  // In the second film, rounding places the first speed of the second shot before its start.
  for (const auto& [first, second] : {std::pair{0.03, 0.07}, {2001.0, 8004.0}}) {
    const MotionCourse course = course_of(
        "[body]\nmoments = [3, 5, 7]\n[motion]\nomega = [0, 1, 0]\n[film]\nfps = 100\n"
        "[[shot]]\nspeed = 1e-3\nlength = " +
        std::to_string(first) +
        "\n[[shot]]\nspeed = 1e-3\nstart = 0\nlength = " + std::to_string(second) + "\n");
    EXPECT_NEAR(course.length, first + second, 1e-3);
    EXPECT_EQ(course.speeds.size(), std::size_t(std::ceil(course.length * course.rate)));
  }
}

TEST(MotionCourse, HasTheFlipsOfTheShotsAtTheirSpeeds) {
  const scene::Scene film =
      scene::parse_scene(scene_of(1, 1) +
                             "[[shot]]\nlength = 8\n"
                             "[[shot]]\nlength = 10\nspeed = [[0, 6], [1, 0.5], [3, 0.5], [4, 8]]\n"
                             "[[shot]]\nlength = 2\nspeed = 0\n"
                             "[[shot]]\nlength = 8\nstart = 2\n",
                         "test.toml");
  const MotionCourse course = motion_course(film);
  EXPECT_DOUBLE_EQ(course.length, 28);
  std::vector<double> expected;  // in s of motion
  double begin = 0;
  std::vector<double> shown;
  for (const scene::Shot& shot : film.shots) {
    const double end = begin + *shot.scene.length;
    for (const double flip : course.flips) {
      if (flip >= begin && flip < end) shown.push_back(shot.time_of(flip - begin));
    }
    const timeline::Timeline motion(shot.scene, std::vector<timeline::FrameTime>());
    for (const double flip : motion.solutions().front().flip_times) {
      if (flip >= shot.start && flip < shot.time_of(*shot.scene.length)) expected.push_back(flip);
    }
    begin = end;
  }
  EXPECT_GE(expected.size(), 4U);
  ASSERT_EQ(shown.size(), expected.size());
  for (std::size_t i = 0; i < shown.size(); ++i) EXPECT_NEAR(shown[i], expected[i], 1e-9);
  // Slow motion is slow, and a frozen motion at rest.
  EXPECT_LT(course.speeds[1000], 0.2F * course.speeds[100]);
  EXPECT_EQ(course.speeds[1900], 0);
}

TEST(MotionCourse, OfMotionsSideBySideIsOfTheFirstThatTurnsOver) {
  scene::Scene film = scene::parse_scene(scene_of(1, 1), "test.toml");
  const MotionCourse flipping = motion_course(film);
  const Eigen::Vector3d omega = film.motion.omega;
  film.overlay.compare_omega = {{1, 0, 0}, omega, {0, 0, 1}};
  EXPECT_EQ(motion_course(film).flips, flipping.flips);
  film.overlay.compare_omega = {{1, 0, 0}, {0, 0, 1}};
  EXPECT_TRUE(motion_course(film).flips.empty());
}

}  // namespace
}  // namespace twrench::sound
