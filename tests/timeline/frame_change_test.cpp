#include "timeline/frame_change.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <numbers>
#include <string>

namespace twrench::timeline {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using scene::Frame;

constexpr double pi = std::numbers::pi;

/// A change of frame that starts at `start` s of motion and goes on at `speed`.
struct Change {
  Change(const motion::FreeBody& of, Frame from, Frame to, double start_, double speed_,
         double length_)
      : body(of),
        motion(of),
        start(start_),
        speed(speed_),
        length(length_),
        change(of, {from, at(0), speed_}, {to, at(length_), speed_}, length_) {}

  /// The motion after `time` seconds of video.
  motion::Sample at(double time) const { return motion.at(start + speed * time); }
  Matrix3d attitude(double time) const { return change.attitude(time, at(time)); }
  /// The angular velocity in space, rad per second of video, between two times.
  Vector3d rate(double from, double to) const {
    return so3::log(attitude(to) * attitude(from).transpose()) / (to - from);
  }
  double about_momentum(const Vector3d& rate) const {
    return rate.dot(body.momentum().stableNormalized());
  }

  motion::FreeBody body;
  motion::ExactMotion motion;
  double start, speed, length;
  FrameChange change;
};

struct Example {
  std::string name;
  Vector3d moments, omega;
};

/// A steady rotation, one that turns over, and a tumbling body, whose sizes are 1e-6 to 1e6 times
/// that of the first: its moments then go with the fifth power.
std::vector<Example> examples() {
  return {{"steady", 1e-30 * Vector3d(3, 4, 5), {0, 0, 1}},
          {"flipping", {3, 4, 5}, {0.01, 1, 0}},
          {"tumbling", 1e30 * Vector3d(3, 4, 5), {0.5, 0.7, 0.4}}};
}

constexpr std::array all_frames_of_reference{Frame::space, Frame::body, Frame::rotating};

template <typename Visit>
void visit_changes(Visit visit) {
  for (const Example& example : examples()) {
    const motion::FreeBody body(example.moments.asDiagonal(), example.omega);
    for (const Frame from : all_frames_of_reference) {
      for (const Frame to : all_frames_of_reference) {
        if (from == to) continue;
        SCOPED_TRACE(example.name + " " + std::to_string(int(from)) + std::to_string(int(to)));
        visit(Change(body, from, to, 13.7, 2.5, 4));
      }
    }
  }
}

TEST(FrameChange, StartsAndEndsInThePosesOfItsFrames) {
  visit_changes([](const Change& change) {
    constexpr double instant = 1e-9;
    for (const double end : {0.0, change.length}) {
      const Matrix3d before = change.attitude(end - instant),
                     after = change.attitude(end + instant);
      EXPECT_LT((before - after).norm(), 1e-7);
      EXPECT_LT((after * after.transpose() - Matrix3d::Identity()).norm(), 1e-12);
    }
  });
}

TEST(FrameChange, TurnsAtTheRatesOfItsFramesAtTheEnds) {
  visit_changes([](const Change& change) {
    constexpr double step = 1e-4;
    for (const double end : {0.0, change.length}) {
      const Vector3d before = change.rate(end - step, end), after = change.rate(end, end + step);
      EXPECT_LT((before - after).norm(), 1e-2) << before.transpose() << ", " << after.transpose();
    }
  });
}

TEST(FrameChange, HasNoJumps) {
  visit_changes([](const Change& change) {
    constexpr double step = 0.01;
    Vector3d last = change.rate(-step, 0);
    for (int i = 0; i < 400; ++i) {
      const Vector3d next = change.rate(i * step, (i + 1) * step);
      EXPECT_LT((next - last).norm(), 0.5) << i;
      last = next;
    }
  });
}

TEST(FrameChange, SpinsUpAndStopsWithoutTurningBackwards) {
  for (const Example& example : examples()) {
    const motion::FreeBody body(example.moments.asDiagonal(), example.omega);
    for (const bool spins_up : {true, false}) {
      for (const double start : {0.0, 1.0, 7.3, 50.0}) {
        const Change change(body, spins_up ? Frame::space : Frame::rotating,
                            spins_up ? Frame::rotating : Frame::space, start, 2.5, 4);
        constexpr double step = 0.01;
        double angle = 0, fastest = 0;
        for (int i = 0; i < 400; ++i) {
          const double rate = change.about_momentum(change.rate(i * step, (i + 1) * step));
          EXPECT_GT(rate, -1e-6) << start << " " << i;
          angle += step * rate;
          fastest = std::max(fastest, rate);
        }
        const double final_rate =
            change.about_momentum(change.rate(spins_up ? 4.1 : -0.2, spins_up ? 4.2 : -0.1));
        EXPECT_GT(angle, 0.4 * 4 * final_rate - 1e-3);
        EXPECT_LT(angle, 0.4 * 4 * final_rate + 2 * pi) << "no turn too many";
        EXPECT_LT(fastest, 2 * final_rate);
      }
    }
  }
}

TEST(FrameChange, ConnectsTheFramesOfABodyAtRest) {
  const motion::FreeBody body(Vector3d(3, 4, 5).asDiagonal(), {0, 1, 0});
  const Change change(body, Frame::space, Frame::rotating, 1.25, 0, 2);
  EXPECT_LT((change.attitude(1e-9) - Matrix3d::Identity()).norm(), 1e-6);
  EXPECT_LT((change.attitude(2) - so3::exp({0, 1.25, 0})).norm(), 1e-12);
  EXPECT_LT((change.attitude(1) - so3::exp({0, 0.625, 0})).norm(), 1e-12) << "the shortest way";
}

TEST(FrameChange, OfABodyAtRestChangesNothing) {
  const motion::FreeBody body(Vector3d(3, 4, 5).asDiagonal(), {0, 0, 0});
  for (const Frame to : {Frame::body, Frame::rotating}) {
    const Change change(body, Frame::space, to, 5, 1, 2);
    for (const double time : {0.0, 0.5, 1.0, 1.9, 3.0}) {
      EXPECT_LT((change.attitude(time) - Matrix3d::Identity()).norm(), 1e-12) << time;
    }
  }
}

}  // namespace
}  // namespace twrench::timeline
