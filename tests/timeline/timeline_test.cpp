#include "timeline/timeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "picture/t_wrench.h"

namespace twrench::timeline {
namespace {

scene::Scene turning_over() {
  scene::Scene scene = picture::t_wrench();
  scene.motion.omega = {1.0, 0.05, 0.0};
  return scene;
}

std::vector<int> all_frames(const scene::Scene& scene) {
  std::vector<int> frames(static_cast<std::size_t>(scene.frame_count()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

void expect_same(const std::vector<motion::Sample>& a, const std::vector<motion::Sample>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].t, b[k].t);
    EXPECT_EQ(a[k].X, b[k].X);
  }
}

void expect_same(const FrameState& a, const FrameState& b) {
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.video_time, b.video_time);
  ASSERT_EQ(a.solutions.size(), b.solutions.size());
  for (std::size_t i = 0; i < a.solutions.size(); ++i) {
    EXPECT_EQ(a.solutions[i].sample.X, b.solutions[i].sample.X);
    EXPECT_EQ(a.solutions[i].flips, b.solutions[i].flips);
    EXPECT_EQ(a.solutions[i].next_flip, b.solutions[i].next_flip);
    expect_same(a.solutions[i].blur, b.solutions[i].blur);
    expect_same(a.solutions[i].trail, b.solutions[i].trail);
  }
}

TEST(Timeline, AMomentDoesNotDependOnTheOtherFrames) {
  scene::Scene scene = turning_over();
  scene.look.motion_blur = 3;
  scene.overlay.compare = {"rk4", "rkmk45", "exact"};
  const Timeline whole(scene, all_frames(scene));
  const Timeline some(scene, {0, 7, 8, 500, 959});
  for (std::size_t i = 0; i < some.size(); ++i) {
    const FrameState state = some.frame_state(i);
    expect_same(state, whole.frame_state(static_cast<std::size_t>(state.frame)));
  }
}

TEST(Timeline, CountsFlipsAndPredictsTheNext) {
  const scene::Scene scene = turning_over();
  const Timeline timeline(scene, all_frames(scene));
  // First flip at 11.8154 s, then every 23.6307 s; a frame is 0.1 s.
  EXPECT_EQ(timeline.frame_state(118).solutions[0].flips, 0U);
  EXPECT_NEAR(timeline.frame_state(118).solutions[0].next_flip.value(), 11.815362623, 1e-8);
  EXPECT_EQ(timeline.frame_state(119).solutions[0].flips, 1U);
  EXPECT_NEAR(timeline.frame_state(119).solutions[0].next_flip.value(), 35.446087870, 1e-8);
  EXPECT_EQ(timeline.frame_state(959).solutions[0].flips, 4U);
}

TEST(Timeline, KnowsNoFlipsAboutAStableAxis) {
  scene::Scene scene = turning_over();
  scene.motion.omega = {0.05, 1.0, 0.0};
  const Timeline timeline(scene, {500});
  EXPECT_FALSE(timeline.frame_state(0).solutions[0].next_flip.has_value());
  EXPECT_EQ(timeline.frame_state(0).solutions[0].flips, 0U);
}

TEST(Timeline, TrailsReachBackAsFarAsTheyShould) {
  scene::Scene scene = turning_over();
  scene.overlay.trail_length = 5;
  const Timeline timeline(scene, {0, 10, 300});
  EXPECT_EQ(timeline.frame_state(0).solutions[0].trail.size(), 1U);
  const std::vector<motion::Sample> early = timeline.frame_state(1).solutions[0].trail;
  EXPECT_EQ(early.front().t, 0);
  EXPECT_EQ(early.back().t, 1);
  const std::vector<motion::Sample> late = timeline.frame_state(2).solutions[0].trail;
  EXPECT_NEAR(late.front().t, 25, 0.1);
  EXPECT_GE(late.front().t, 25);
  EXPECT_EQ(late.back().t, 30);
  for (std::size_t i = 1; i < late.size(); ++i) {
    EXPECT_LT((late[i].X - late[i - 1].X).norm(), 0.1);
  }
}

TEST(Timeline, LeavesOutTrailsThatAreNotShown) {
  scene::Scene scene = turning_over();
  scene.overlay.show.erase(scene::Feature::trail);
  EXPECT_TRUE(Timeline(scene, {300}).frame_state(0).solutions[0].trail.empty());
}

TEST(Timeline, BlursOverHalfTheFramesTimeAboutItsInstant) {
  scene::Scene scene = turning_over();
  scene.look.motion_blur = 2;
  scene.motion.method = "exact";
  const Timeline timeline(scene, {100});
  const SolutionState instant = timeline.frame_state(0).solutions[0];
  ASSERT_EQ(instant.blur.size(), 2U);
  const motion::ExactMotion motion(timeline.solutions()[0].body);
  EXPECT_EQ(instant.blur[0].X, motion.at(10 - 0.0125).X);
  EXPECT_EQ(instant.blur[1].X, motion.at(10 + 0.0125).X);
}

// Poses look like a comb if they are more than a few pixels apart.
TEST(Timeline, BlursWithAsManyPosesAsTheSpeedNeeds) {
  scene::Scene scene = turning_over();
  scene.film.width = 1920;
  scene.film.height = 1080;
  scene.look.motion_blur = 4;
  const auto poses = [&](double speed) {
    scene.film.speed = speed;
    return Timeline(scene, frame_times(scene.film, {100})).frame_state(0).solutions[0].blur;
  };
  EXPECT_EQ(poses(0.5).size(), 4U);
  const std::vector<motion::Sample> fast = poses(60);
  for (std::size_t i = 1; i < fast.size(); ++i) {
    const Eigen::Matrix3d turn = fast[i - 1].X.transpose() * fast[i].X;
    EXPECT_LT(540 * std::acos((turn.trace() - 1) / 2), 3.5) << "pixels at the picture's edge";
  }
  EXPECT_EQ(poses(600).size(), 256U);
  scene.look.motion_blur = 1;
  EXPECT_TRUE(poses(60).empty());
}

TEST(Timeline, ShowsEachComparedMethodsOwnDrift) {
  scene::Scene scene = turning_over();
  scene.overlay.compare = {"lie-euler", "exact"};
  const FrameState state = Timeline(scene, {600}).frame_state(0);
  EXPECT_GT(std::abs(state.solutions[0].diagnostics.energy_drift), 1e-4);
  EXPECT_LT(std::abs(state.solutions[1].diagnostics.energy_drift), 1e-13);
}

TEST(Timeline, DescribesABodyAtRest) {
  scene::Scene scene = turning_over();
  scene.motion.omega.setZero();
  const SolutionState instant = Timeline(scene, {100}).frame_state(0).solutions[0];
  EXPECT_EQ(instant.sample.X, Eigen::Matrix3d::Identity());
  EXPECT_FALSE(instant.next_flip.has_value());
}

}  // namespace
}  // namespace twrench::timeline
