// Scenes that show recorded motions, against the exact motion.
#include "replay/replay.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "sanitizers.h"
#include "scene/interior.h"
#include "scene/natural_times.h"
#include "scene/scene_json.h"
#include "scene/shown_recording.h"
#include "timeline/timeline.h"

namespace twrench::replay {
namespace {

using Eigen::Vector3d;
using scene::Feature;
using testing::ElementsAre;
using testing::HasSubstr;

/// Rows of times, rates and quaternions of the body's exact motion. `spoil` changes the rates.
template <typename Spoil>
std::string table_of(const motion::FreeBody& body, double duration, int rows, const Spoil& spoil) {
  const motion::ExactMotion motion(body);
  std::string text = "t,wx,wy,wz,qw,qx,qy,qz\n";
  for (int i = 0; i < rows; ++i) {
    const double t = duration * i / (rows - 1);
    const motion::Sample sample = motion.at(t);
    const Vector3d omega = spoil(sample.omega);
    const auto q = sample.quaternion();
    text += fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", t,
                        omega.x(), omega.y(), omega.z(), q.w(), q.x(), q.y(), q.z());
  }
  return text;
}

std::string table_of(const motion::FreeBody& body, double duration, int rows) {
  return table_of(body, duration, rows, [](const Vector3d& omega) { return omega; });
}

void show(scene::Scene& scene, const std::string& text, Body body = Body::known) {
  show_recording(scene, recording::Recording(table::open_table("run.csv", text)), {}, body);
  scene::set_natural_times(scene);
}

/// The largest angle in rad between what the frames show and the exact motion.
double error_of_frames(const scene::Scene& scene, const motion::FreeBody& body) {
  std::vector<int> frames;
  for (int i = 0; i < 100; ++i) frames.push_back(i * (scene.frame_count() - 1) / 99);
  const timeline::Timeline timeline(scene, frames);
  const motion::ExactMotion motion(body);
  double error = 0;
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const motion::Sample sample = timeline.frame_state(i).solutions.front().sample;
    const Eigen::Matrix3d ought = motion.at(sample.t).X;
    error = std::max(error, so3::log(ought.transpose() * sample.X).norm());
  }
  return error;
}

/// Makes a scene of a rigid body one that can show a recording. Returns whether it is one.
bool is_shown_alone(scene::Scene& scene) {
  scene.overlay.compare_omega.clear();
  scene.overlay.compare_wheel.clear();
  scene.overlay.compare.clear();
  scene.camera.frame = scene::Frame::space;
  return scene.shots.empty() && scene.motion.is_rigid();
}

TEST(ShowRecording, ShowsTheMotionOfEveryBuiltInScene) {
  int shown = 0;
  for (const std::string& name : scene::builtin_scene_names()) {
    scene::Scene scene = scene::load_scene(name);
    if (!is_shown_alone(scene)) continue;
    const motion::FreeBody body = scene::free_body(scene);
    const double turn = 2 * std::numbers::pi / scene::fastest_rate(body), duration = 20 * turn;
    show(scene, table_of(body, duration, 801));
    EXPECT_LT(error_of_frames(scene, body), 1e-6) << name;
    EXPECT_THAT(scene.motion.recording->notes, ElementsAre()) << name;
    EXPECT_NEAR(scene.motion.duration, duration, 1e-9 * duration);
    EXPECT_GE(scene.video_length(), 10 - 1e-9);
    EXPECT_LE(scene.video_length(), 30 + 1e-9);
    EXPECT_EQ(scene.title, "run.csv");
    ++shown;
  }
  EXPECT_GT(shown, 5);
}

scene::Scene with_moments(const Vector3d& moments) {
  scene::Scene scene;
  scene.name = "body";
  scene.body.inertia = moments.asDiagonal();
  return scene;
}

TEST(ShowRecording, ShowsBodiesOfEverySizeAndSpeed) {
  for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const double inertia = std::pow(size, 5), speed = std::sqrt(1 / size);
    scene::Scene scene = with_moments(inertia * Vector3d(2, 3, 4.5));
    const motion::FreeBody body(*scene.body.inertia, speed * Vector3d(0.3, 2, 0.4));
    show(scene, table_of(body, 20 / speed, 1001));
    EXPECT_LT(error_of_frames(scene, body), 1e-6) << size;
    EXPECT_TRUE(scene.overlay.shows(Feature::momentum)) << size;
    EXPECT_THAT(scene.motion.recording->flip_times, testing::SizeIs(testing::Gt(1U))) << size;
  }
}

const motion::FreeBody& tumbling() {
  static const motion::FreeBody body(Vector3d(2, 3, 4.5).asDiagonal(), Vector3d(0.3, 2, 0.4));
  return body;
}

TEST(ShowRecording, FindsTheFlips) {
  scene::Scene scene = with_moments({2, 3, 4.5});
  show(scene, table_of(tumbling(), 20, 1001));
  const auto flips = *motion::ExactMotion(tumbling()).flips();
  std::vector<double> exact;
  for (double t = flips.first; t < 20; t += flips.interval) exact.push_back(t);
  EXPECT_THAT(scene.motion.recording->flip_times,
              testing::Pointwise(testing::DoubleNear(1e-6), exact));
}

TEST(ShowRecording, ComesFirstBesideTheExactMotion) {
  scene::Scene scene = with_moments({2, 3, 4.5});
  scene.overlay.compare = {"exact"};
  show(scene, table_of(tumbling(), 20, 1001));
  EXPECT_THAT(scene.overlay.compare, ElementsAre("recorded", "exact"));
  const timeline::Timeline timeline(scene, std::vector<int>{0, 100, 600});
  ASSERT_EQ(timeline.solutions().size(), 2U);
  EXPECT_EQ(timeline.solutions()[0].name, "recorded");
  EXPECT_TRUE(timeline.solutions()[0].recording);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& states = timeline.frame_state(i).solutions;
    EXPECT_LT((states[0].sample.X - states[1].sample.X).norm(), 1e-6);
  }
}

/// With noise, the free motion is the fitted one; the first row's would miss the last rows by far.
TEST(ShowRecording, FitsTheFreeMotionToNoise) {
  std::mt19937 random(7);
  scene::Scene scene = with_moments({2, 3, 4.5});
  scene.overlay.compare = {"exact"};
  const auto noise = [&] { return 0.01 * (double(random()) / double(random.max()) - 0.5); };
  show(scene, table_of(tumbling(), 20, 301, [&](const Vector3d& omega) -> Vector3d {
         return omega + Vector3d(noise(), noise(), noise());
       }));
  EXPECT_LT((scene.motion.omega - tumbling().omega()).norm(), 1e-3);
  EXPECT_TRUE(scene.overlay.shows(Feature::momentum));
}

/// Rates with noise of a twentieth of their size, uniform in each component.
std::string noisy_table_of(const motion::FreeBody& body, double duration) {
  std::mt19937 random(7);
  const double most = body.omega().norm() / 20 * std::sqrt(3.0);
  const auto noise = [&] { return most * (2 * double(random()) / double(random.max()) - 1); };
  return table_of(body, duration, 401, [&](const Vector3d& omega) -> Vector3d {
    return omega + Vector3d(noise(), noise(), noise());
  });
}

/// The root mean square of the errors of a component of the rates, relative to their noise.
double share_of_noise(const scene::Scene& scene, const motion::FreeBody& body) {
  const motion::ExactMotion motion(body);
  double squares = 0;
  const auto& instants = scene.motion.recording->motion.instants();
  for (const motion::RecordedMotion::Instant& instant : instants) {
    squares += (instant.omega - motion.at(instant.t).omega).squaredNorm();
  }
  return std::sqrt(squares / (3 * double(instants.size()))) / (body.omega().norm() / 20);
}

/// Smoothing leaves at most half of the noise, and the notes name it before and after.
void expect_smoother(const scene::Scene& plain, const motion::FreeBody& body, double duration) {
  const std::string text = noisy_table_of(body, duration);
  for (const auto smoothing : {recording::Smoothing::none, recording::Smoothing::within_noise}) {
    const bool smooth = smoothing == recording::Smoothing::within_noise;
    scene::Scene scene = plain;
    show_recording(scene, recording::Recording(table::open_table("run.csv", text)), {}, Body::known,
                   smoothing);
    const double share = share_of_noise(scene, body);
    EXPECT_TRUE(smooth ? share < 0.5 : std::abs(share - 1) < 0.1) << plain.name << " " << share;
    EXPECT_THAT(scene.motion.recording->notes,
                testing::Contains(HasSubstr(smooth ? "is smoothed" : "can be seen")))
        << plain.name;
  }
}

TEST(ShowRecording, SmoothsTheNoiseOfEveryBuiltInScene) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  int shown = 0;
  for (const std::string& name : scene::builtin_scene_names()) {
    scene::Scene scene = scene::load_scene(name);
    if (!is_shown_alone(scene)) continue;
    const motion::FreeBody body = scene::free_body(scene);
    expect_smoother(scene, body, 20 * std::numbers::pi / scene::fastest_rate(body));
    ++shown;
  }
  EXPECT_GT(shown, 5);
  for (const double size : {1e-6, 1e6}) {
    const double speed = std::sqrt(1 / size);
    const scene::Scene scene = with_moments(std::pow(size, 5) * Vector3d(2, 3, 4.5));
    const motion::FreeBody body(*scene.body.inertia, speed * Vector3d(0.3, 2, 0.4));
    expect_smoother(scene, body, 10 / speed);
  }
}

TEST(ShowRecording, LeavesOutWhatNeedsAFreeMotion) {
  scene::Scene scene = with_moments({2, 3, 4.5});
  // As if the rates had been computed without the gyroscopic term.
  show(scene, table_of(tumbling(), 20, 201, [](const Vector3d&) { return tumbling().omega(); }));
  EXPECT_FALSE(scene.overlay.shows(Feature::momentum));
  EXPECT_FALSE(scene.overlay.shows(Feature::sphere));
  EXPECT_TRUE(scene.overlay.shows(Feature::omega));
  ASSERT_EQ(scene.motion.recording->notes.size(), 1U);
  EXPECT_THAT(scene.motion.recording->notes[0], HasSubstr("left out: momentum, sphere"));
}

TEST(ShowRecording, ShowsABoxForABodyThatIsNotKnown) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  show(scene, table_of(tumbling(), 20, 1001), Body::unknown);
  EXPECT_LT(error_of_frames(scene, tumbling()), 1e-6);
  EXPECT_EQ(scene.name, "run");
  EXPECT_TRUE(scene.body.parts.empty());
  EXPECT_FALSE(scene.overlay.shows(Feature::momentum));
  EXPECT_THAT(scene.motion.recording->notes,
              ElementsAre(HasSubstr("the body is not given, by a scene, a mesh or its inertia")));
}

/// The identity of a film depends on the rows, so that frames of another recording are not kept.
TEST(ShowRecording, ChangesTheSceneWithEachRow) {
  const std::string text = table_of(tumbling(), 20, 101);
  const std::string other = table_of(
      tumbling(), 20, 101, [](const Vector3d& omega) -> Vector3d { return omega * (1 + 1e-12); });
  std::vector<std::string> digests;
  for (const std::string& rows : {text, text, other}) {
    scene::Scene scene = with_moments({2, 3, 4.5});
    show(scene, rows);
    digests.push_back(scene::scene_json(scene)["motion"]["recording"]["sha256"]);
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_NE(digests[0], digests[2]);
}

std::string refusal(scene::Scene scene) {
  try {
    show(scene, table_of(tumbling(), 20, 101));
    scene::check_shown_motion(scene);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "no error";
}

TEST(ShowRecording, RefusesWhatItCannotShow) {
  EXPECT_THAT(refusal(scene::load_scene("explain")), HasSubstr("have separate motions"));
  scene::Scene scene = with_moments({2, 3, 4.5});
  scene.overlay.compare_omega = {{1, 0, 0}, {0, 1, 0}};
  EXPECT_THAT(refusal(scene), HasSubstr("it has one start"));
  scene.overlay.compare_omega.clear();
  scene.overlay.compare = {"rk4", "rkmk4", "euler", "exact"};
  EXPECT_THAT(refusal(scene), HasSubstr("at most 4 motions are drawn side by side, and it is one"));
  scene.overlay.compare.clear();
  scene.camera.frame = scene::Frame::rotating;
  EXPECT_THAT(refusal(scene), HasSubstr("the rotating frame"));
  scene.camera.frame = scene::Frame::space;
  scene.motion.duration = 21;
  scene.origins.duration = scene::Origin::user;
  scene.overlay.view = scene::View::poinsot;
  scene.body.inertia = Vector3d(3, 2, 4.5).asDiagonal();  // not that of the recording
  EXPECT_THAT(refusal(scene), HasSubstr("the view poinsot is that of a free motion, but run.csv"));
  scene.overlay.view = scene::View::wrench;
  EXPECT_EQ(refusal(scene), "run.csv: it lasts 20 s, but 21 s are to be shown");
}

TEST(ShowRecording, ComparesNothingWithABodyThatIsNotKnown) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.overlay.compare = {"exact"};
  EXPECT_THROW(show(scene, table_of(tumbling(), 20, 101), Body::unknown), InvalidArgument);
}

}  // namespace
}  // namespace twrench::replay
