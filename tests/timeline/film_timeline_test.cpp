#include "timeline/film_timeline.h"

#include <gtest/gtest.h>
#include <twrench/motion/error.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "scene/scene.h"

namespace twrench::timeline {
namespace {

scene::Scene story_of_three() {
  return scene::parse_scene(R"(
[body]
moments = [3, 4, 5]
[motion]
omega = [0.05, 1, 0]
method = "exact"
[film]
fps = 10
speed = 3
[overlay]
show = ["trail"]
[[shot]]
length = 2
caption = "One"
[[shot]]
length = 3
fade = 1
move = 2
caption = "Two"
speed = [[0, 3], [1, 1], [2, 0]]
[[shot]]
length = 1
fade = 0.5
caption = "Two"
start = 30
)",
                            "story.toml");
}

std::vector<int> frames_of_all_shots(const scene::Scene& scene) {
  std::vector<int> frames(static_cast<std::size_t>(scene.frame_count()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

double motion_time(const FrameState& state) { return state.solutions[0].sample.t; }

TEST(FilmTimeline, AFilmOfOneMotionIsThatOfItsTimeline) {
  scene::Scene scene = story_of_three();
  scene.shots.clear();
  const std::vector<int> frames{0, 3, 7, 50};
  const Timeline alone(scene, frames);
  const FilmTimeline film(scene, frames);
  ASSERT_EQ(film.size(), 4u);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FilmFrame frame = film.frame(i);
    EXPECT_EQ(frame.shot, 0u);
    EXPECT_EQ(frame.faded, 1);
    EXPECT_EQ(frame.moved, 1);
    EXPECT_FALSE(frame.previous);
    EXPECT_EQ(frame.state.frame, frames[i]);
    EXPECT_EQ(frame.state.video_time, frames[i] / 10.0);
    EXPECT_EQ(frame.state.solutions[0].sample.X, alone.frame_state(i).solutions[0].sample.X);
  }
}

TEST(FilmTimeline, EachShotHasItsOwnClock) {
  const scene::Scene scene = story_of_three();
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  ASSERT_EQ(film.size(), 60u);
  EXPECT_EQ(film.frame(19).shot, 0u);
  EXPECT_EQ(motion_time(film.frame(19).state), 1.9 * 3);
  EXPECT_EQ(film.frame(20).shot, 1u);
  EXPECT_EQ(film.frame(20).state.video_time, 0);
  EXPECT_EQ(motion_time(film.frame(20).state), 6) << "goes on where the first ended";
  EXPECT_DOUBLE_EQ(motion_time(film.frame(25).state), 6 + 0.5 * (3 + 2) / 2);
  EXPECT_DOUBLE_EQ(motion_time(film.frame(45).state), 6 + 2 + 0.5) << "frozen";
  EXPECT_EQ(motion_time(film.frame(49).state), motion_time(film.frame(45).state));
  EXPECT_EQ(motion_time(film.frame(50).state), 30);
}

TEST(FilmTimeline, ThePreviousShotContinuesWhileItIsVisible) {
  const scene::Scene scene = story_of_three();
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  const FilmFrame first = film.frame(20);
  EXPECT_EQ(first.faded, 0);
  EXPECT_EQ(first.moved, 0);
  ASSERT_TRUE(first.previous);
  EXPECT_EQ(first.previous->video_time, 2);
  EXPECT_EQ(motion_time(*first.previous), 6);
  const FilmFrame middle = film.frame(25);
  EXPECT_DOUBLE_EQ(middle.faded, 0.5);
  EXPECT_DOUBLE_EQ(motion_time(*middle.previous), 7.5);
  EXPECT_EQ(film.frame(30).faded, 1);
  EXPECT_DOUBLE_EQ(film.frame(30).moved, 0.5) << "the camera still comes from there";
  EXPECT_TRUE(film.frame(30).previous);
  EXPECT_FALSE(film.frame(40).previous);
}

// The share is s^2 (3 - 2 s), where s is the share of the time, so that it rests at both ends.
TEST(FilmTimeline, FadesAndCameraMovesStartAndEndGently) {
  const scene::Scene scene = story_of_three();  // fade = 1 s, move = 2 s, from frame 20 at 10 fps
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  EXPECT_DOUBLE_EQ(film.frame(21).faded, 0.028);
  EXPECT_DOUBLE_EQ(film.frame(22).faded, 0.104);
  EXPECT_DOUBLE_EQ(film.frame(29).faded, 0.972);
  EXPECT_DOUBLE_EQ(film.frame(22).moved, 0.028);
  EXPECT_DOUBLE_EQ(film.frame(25).moved, 0.15625);
  EXPECT_DOUBLE_EQ(film.frame(38).moved, 0.972);
}

TEST(FilmTimeline, OneCaptionDisappearsBeforeTheNextAppears) {
  const scene::Scene scene = story_of_three();
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  for (int i = 20; i < 30; ++i) {
    const FilmFrame frame = film.frame(static_cast<std::size_t>(i));
    EXPECT_EQ(frame.state.caption_opacity * frame.previous->caption_opacity, 0) << i;
  }
  EXPECT_EQ(film.frame(20).previous->caption_opacity, 1);
  EXPECT_EQ(film.frame(30).state.caption_opacity, 1);
  EXPECT_EQ(film.frame(52).state.caption_opacity, 1) << "the same caption stays";
  EXPECT_EQ(film.frame(52).previous->caption_opacity, 1);
}

TEST(FilmTimeline, TextLeavesBeforeTheEndOfItsShot) {
  scene::Scene scene = story_of_three();
  scene.film.text_fade = 0.4;
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  EXPECT_EQ(film.frame(16).state.caption_opacity, 1);
  EXPECT_NEAR(film.frame(18).state.caption_opacity, 0.5, 1e-12);
  EXPECT_NEAR(film.frame(19).state.caption_opacity, 0.15625, 1e-12);
  for (int i = 20; i < 30; ++i) {
    EXPECT_EQ(film.frame(static_cast<std::size_t>(i)).previous->caption_opacity, 0) << i;
  }
  EXPECT_EQ(film.frame(48).state.caption_opacity, 1) << "the same caption stays";
  // The second shot shows the text of the first, and the third that of another time.
  EXPECT_EQ(film.frame(19).state.text_opacity, 1);
  EXPECT_EQ(film.frame(25).previous->text_opacity, 1);
  EXPECT_NEAR(film.frame(48).state.text_opacity, 0.5, 1e-12);
  EXPECT_EQ(film.frame(52).previous->text_opacity, 0);
  EXPECT_EQ(film.frame(59).state.text_opacity, 1) << "the film's last text stays";
  scene.shots[2].fade = 0;
  EXPECT_EQ(FilmTimeline(scene, {49}).frame(0).state.text_opacity, 1) << "before a cut";
  scene.shots[1].scene.overlay.show.clear();
  EXPECT_LT(FilmTimeline(scene, {19}).frame(0).state.text_opacity, 1) << "without the first's";
}

TEST(FilmTimeline, AFrameDoesNotDependOnTheOthers) {
  const scene::Scene scene = story_of_three();
  const FilmTimeline whole(scene, frames_of_all_shots(scene));
  const std::vector<int> numbers{0, 21, 29, 33, 47, 51, 59};
  const FilmTimeline some(scene, numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const FilmFrame a = some.frame(i);
    const FilmFrame b = whole.frame(static_cast<std::size_t>(numbers[i]));
    EXPECT_EQ(a.shot, b.shot);
    EXPECT_EQ(some.shot(i), a.shot);
    EXPECT_EQ(a.faded, b.faded);
    EXPECT_EQ(a.moved, b.moved);
    ASSERT_EQ(a.previous.has_value(), b.previous.has_value());
    for (const auto& [one, other] :
         {std::pair(&a.state, &b.state),
          {a.previous ? &*a.previous : &a.state, b.previous ? &*b.previous : &b.state}}) {
      EXPECT_EQ(one->frame, other->frame);
      EXPECT_EQ(one->solutions[0].sample.X, other->solutions[0].sample.X);
      ASSERT_EQ(one->solutions[0].trail.size(), other->solutions[0].trail.size());
      for (std::size_t k = 0; k < one->solutions[0].trail.size(); ++k) {
        EXPECT_EQ(one->solutions[0].trail[k].X, other->solutions[0].trail[k].X);
      }
    }
  }
}

TEST(FilmTimeline, KnowsTheMoveToAnotherFrameOfReference) {
  scene::Scene scene = story_of_three();
  scene.shots[1].scene.camera.frame = scene::Frame::rotating;
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  EXPECT_FALSE(film.frame(19).state.move);
  const FilmFrame frame = film.frame(25);
  ASSERT_TRUE(frame.state.move && frame.state.move->change);
  EXPECT_EQ(frame.state.move_time, 0.5);
  EXPECT_EQ(frame.previous->move, frame.state.move);
  EXPECT_EQ(frame.previous->move_time, 0.5);
  EXPECT_EQ(motion_time(*frame.previous), motion_time(frame.state)) << "one pose";
  const CameraMove& move = *frame.state.move;
  EXPECT_EQ(move.share(-1), 0);
  EXPECT_EQ(move.share(1), 0.5);
  EXPECT_EQ(move.time_of(8.5, 3), 3) << "the motion stands still from 2 s on";
  EXPECT_NEAR(move.time_of(7.25, 3), 0.5, 1e-12);
  EXPECT_EQ(move.time_of(7.25, 0.2), 0.2);
  EXPECT_EQ(move.time_of(5, 3), 0);
  scene.shots[1].continues = false;
  const FilmTimeline other(scene, frames_of_all_shots(scene));
  ASSERT_TRUE(other.frame(25).state.move);
  EXPECT_FALSE(other.frame(25).state.move->change) << "the motions differ";
  EXPECT_EQ(motion_time(*other.frame(25).previous), 7.5);
}

TEST(FilmTimeline, TheTrailsOfStarsCoverTheirTime) {
  scene::Scene scene = story_of_three();
  for (scene::Shot& shot : scene.shots) shot.scene.overlay.star_trail = 0.8;
  const FilmTimeline film(scene, frames_of_all_shots(scene)), alone(scene, {47});
  const FrameState state = film.frame(47).state;
  EXPECT_NEAR(state.star_times.front(), 2.7 - 0.8, 0.026);
  EXPECT_EQ(state.star_times.back(), 2.7);
  ASSERT_EQ(state.solutions[0].stars.size(), state.star_times.size());
  for (std::size_t i = 0; i < state.star_times.size(); ++i) {
    EXPECT_EQ(state.solutions[0].stars[i].t, scene.shots[1].time_of(state.star_times[i]));
    EXPECT_EQ(state.solutions[0].stars[i].X, alone.frame(0).state.solutions[0].stars[i].X);
  }
  EXPECT_EQ(film.frame(0).state.solutions[0].stars.front().t, 0) << "not before the start";
}

TEST(FilmTimeline, CountsTheFlipsOnTheClockOfEachShot) {
  scene::Scene scene = story_of_three();
  for (scene::Shot& shot : scene.shots) shot.scene.motion.omega *= 4;
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  const motion::ExactMotion motion(film.solutions(0)[0].body);
  const std::vector<double> flips = motion.flip_times(40);
  ASSERT_GE(flips.size(), 3u);
  int least = 99, most = 0;
  for (std::size_t i = 0; i < film.size(); ++i) {
    const double t = motion_time(film.frame(i).state);
    const auto count = std::ranges::count_if(flips, [&](double flip) { return flip <= t; });
    const auto [found, last] = film.flips(i);
    EXPECT_EQ(found, count) << i;
    EXPECT_EQ(last, count == 0 ? 0 : flips[static_cast<std::size_t>(count) - 1]) << i;
    least = std::min(least, found);
    most = std::max(most, found);
  }
  EXPECT_EQ(least, 0);
  EXPECT_GE(most, 2);
}

TEST(FilmTimeline, StopsIntegratingTheMotionsOfShots) {
  scene::Scene scene = story_of_three();
  for (scene::Shot& shot : scene.shots) shot.scene.motion.method = "rkmk4";
  const std::atomic<bool> stop = true;
  try {
    const FilmTimeline film(scene, {0}, &stop);
    FAIL() << "it integrated";
  } catch (const motion::MotionError& error) {
    EXPECT_EQ(error.reason(), motion::MotionError::Reason::stopped);
  }
}

TEST(FilmTimeline, CountsTheFlipsOfTheFirstMotionThatHasAny) {
  scene::Scene scene = story_of_three();
  scene.shots.clear();
  scene.overlay.compare_omega = {{1, 0, 0}, {0.05, 1, 0}};
  const FilmTimeline film(scene, {299});
  EXPECT_GT(film.flips(0).count, 0);
  scene.overlay.compare_omega = {{1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(FilmTimeline(scene, {299}).flips(0).count, 0);
}

TEST(MotionTimes, AreThoseOfTheFrames) {
  const scene::Scene scene = story_of_three();
  const FilmTimeline film(scene, frames_of_all_shots(scene));
  const std::vector<double> times = motion_times(scene);
  ASSERT_EQ(times.size(), 60u);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(times[i], motion_time(film.frame(i).state)) << i;
  }
}

TEST(FilmTimeline, BlursOverTheMotionOfItsFrame) {
  scene::Scene scene = story_of_three();
  for (scene::Shot& shot : scene.shots) {
    shot.scene.look.motion_blur = 2;
    shot.scene.film.width = shot.scene.film.height = 16;  // so small that two poses suffice
  }
  const FilmTimeline film(scene, {10, 49});
  const motion::ExactMotion motion(film.solutions(0)[0].body);
  EXPECT_EQ(film.frame(0).state.solutions[0].blur[0].X, motion.at(3 - 0.125 * 0.3).X);
  const FilmFrame frozen = film.frame(1);
  EXPECT_EQ(frozen.state.solutions[0].blur[0].X, frozen.state.solutions[0].sample.X);
}

TEST(FilmTimeline, ShowsMotionsFromDifferentStartsSideBySide) {
  scene::Scene scene = story_of_three();
  scene.shots.clear();
  scene.overlay.compare_omega = {{0, 1, 0.01}, {1, 0, 0}, {0.5, 0.5, 0}};
  const FilmTimeline film(scene, {5});
  const auto& solutions = film.solutions(0);
  ASSERT_EQ(solutions.size(), 3u);
  EXPECT_EQ(solutions[0].name, "middle, 4 g cm²");
  EXPECT_EQ(solutions[1].name, "least, 3 g cm²");
  EXPECT_EQ(solutions[2].name, "(0.5, 0.5, 0) rad/s");
  EXPECT_EQ(solutions[1].body.omega(), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(film.frame(0).state.solutions.size(), 3u);

  scene.body = {{}, Eigen::Vector3d(4, 4, 5).asDiagonal().toDenseMatrix()};
  EXPECT_EQ(FilmTimeline(scene, {5}).solutions(0)[0].name, "y, 4 g cm²") << "two are equal";
}

}  // namespace
}  // namespace twrench::timeline
