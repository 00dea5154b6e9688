#include "interchange/track.h"

#include <gtest/gtest.h>
#include <twrench/motion/error.h>

#include <atomic>
#include <limits>
#include <random>

#include "interchange/error.h"
#include "interchange/key_times.h"
#include "interchange/playback.h"
#include "motion/bodies_of_every_kind.h"
#include "sanitizers.h"

namespace twrench::interchange {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Worst {
  double slerp = 0, nlerp = 0, length = 0;
};

/// The largest errors of the played attitude between all keys, at many times.
Worst attitude_error(const Track& track, const PlayedMotion& motion) {
  Worst worst;
  for (std::size_t i = 0; i + 1 < track.times.size(); ++i) {
    for (const double share : {0.0, 0.13, 0.21, 0.38, 0.5, 0.66, 0.79, 0.9, 1.0}) {
      const double time = (1 - share) * track.times[i] + share * track.times[i + 1];
      const Matrix3d X = motion.at(time).X;
      const auto error = [&](Interpolation interpolation) {
        return angle_between(played_rotation(track.times, track.rotations, time, interpolation), X);
      };
      worst.slerp = std::max(worst.slerp, error(Interpolation::slerp));
      worst.nlerp = std::max(worst.nlerp, error(Interpolation::nlerp));
    }
  }
  return worst;
}

Worst omega_error(const Track& track, const PlayedMotion& motion) {
  Worst worst;
  const double initial = motion.at(0).omega.norm();
  for (std::size_t i = 0; i + 1 < track.times.size(); ++i) {
    for (const double share : {0.0, 0.21, 0.5, 0.79, 1.0}) {
      const double time = (1 - share) * track.times[i] + share * track.times[i + 1];
      const motion::Sample sample = motion.at(time);
      const auto error = [&](Interpolation interpolation) {
        return angle_between(
            played_rotation(track.times, track.rotations, time, interpolation) * Vector3d::UnitZ(),
            sample.X * sample.omega);
      };
      const double length = (1 - share) * track.lengths[i] + share * track.lengths[i + 1];
      worst.slerp = std::max(worst.slerp, error(Interpolation::slerp));
      worst.nlerp = std::max(worst.nlerp, error(Interpolation::nlerp));
      worst.length = std::max(worst.length, std::abs(length * initial / sample.omega.norm() - 1));
    }
  }
  return worst;
}

void expect_well_formed(const Track& track, double end) {
  ASSERT_GE(track.times.size(), 2U);
  EXPECT_EQ(track.times.front(), 0);
  EXPECT_EQ(track.times.back(), static_cast<float>(end));
  for (std::size_t i = 0; i + 1 < track.times.size(); ++i) {
    ASSERT_LT(track.times[i], track.times[i + 1]);
    const Eigen::Vector4f a(&track.rotations[4 * i]), b(&track.rotations[4 * i + 4]);
    ASSERT_GT(a.dot(b), 0);
    ASSERT_NEAR(a.norm(), 1, 2e-7);
  }
}

PlayedMotion the_film() {
  const Matrix3d inertia = Vector3d(500, 1000, 1300).asDiagonal();
  return {motion::FreeBody(inertia, {0.05, 1, 0}), 1, 96};
}

/// Checks the tracks of the body during 20 rad of its initial rotation.
void expect_within_bounds(const motion::FreeBody& body) {
  const Vector3d& omega = body.omega();
  const double end = 20 / std::max(omega.norm(), 1.0);
  SCOPED_TRACE(testing::PrintToString(body.principal().moments.transpose()) + "; " +
               testing::PrintToString(omega.transpose()));
  for (const double speed : {1.0, 6.0}) {
    const PlayedMotion motion(body, speed, end / speed);
    for (const double bound : {1e-5, 1e-3}) {
      const Track attitude = attitude_track(motion, end / speed, bound);
      expect_well_formed(attitude, end / speed);
      const Worst worst = attitude_error(attitude, motion);
      EXPECT_LE(worst.slerp, bound);
      EXPECT_LE(worst.nlerp, bound);
      if (omega.isZero(0)) continue;
      const Track arrow = omega_track(motion, end / speed, bound);
      expect_well_formed(arrow, end / speed);
      const Worst of_arrow = omega_error(arrow, motion);
      EXPECT_LE(of_arrow.slerp, bound);
      EXPECT_LE(of_arrow.nlerp, bound);
      EXPECT_LE(of_arrow.length, bound);
    }
  }
}

TEST(Track, OfEveryBodyIsWithinTheBoundAtAnyInstant) {
  std::vector<motion::BodyOfAKind> bodies = motion::bodies_of_every_kind();
  if (has_sanitizers) bodies.resize(20);  // the others are random ones
  for (const auto& [moments, omega] : bodies) {
    expect_within_bounds(motion::FreeBody(moments.asDiagonal(), omega));
  }
}

// The first wheel makes omega nearly vanish during the motion.
TEST(Track, OfABodyWithAWheelOrAnEnergyLossIsWithinTheBound) {
  const Matrix3d inertia = Vector3d(500, 1000, 1300).asDiagonal(), space = Matrix3d::Identity();
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<motion::Interior> interiors{{{-30, -940, 20}, never},
                                          {{100, 200, 50}, 10},
                                          {{0, 300, 0}, never},
                                          {{2000, -100, 500}, never},
                                          {Vector3d::Zero(), 10}};
  if (has_sanitizers) interiors.resize(2);  // one with a wheel, one with both
  for (const motion::Interior& interior : interiors) {
    expect_within_bounds(motion::FreeBody(inertia, {0.05, 1, 0}, space, interior));
  }
}

// There are no needless keys: the error comes near the bound.
TEST(Track, HasKeysOnlyWhereTheMotionNeedsThem) {
  const PlayedMotion motion = the_film();
  for (const double bound : {1e-5, 1e-4, 1e-3}) {
    EXPECT_GT(attitude_error(attitude_track(motion, 96, bound), motion).slerp, 0.6 * bound);
  }
}

// The powers of two scale without rounding.
TEST(Track, HasTheKeysOfASlowMotionThatIsPlayedFaster) {
  const Matrix3d inertia = Vector3d(500, 1000, 1300).asDiagonal();
  const auto keys = [&](double speed) {
    const motion::FreeBody body(inertia, Vector3d(0.125, 1, 0) / speed);
    return attitude_track(PlayedMotion(body, speed, 96), 96, 1e-4).times;
  };
  const std::vector<float> expected = keys(1);
  for (const double speed : {0x1p-10, 0x1p10}) EXPECT_EQ(keys(speed), expected) << speed;
}

TEST(Track, EndsIfItIsStopped) {
  const std::atomic<bool> stop = true;
  const PlayedMotion motion(motion::FreeBody(Matrix3d::Identity(), Vector3d::UnitX()), 1, 96,
                            &stop);
  EXPECT_THROW(attitude_track(motion, 96, 1e-4), motion::MotionError);
}

TEST(Track, OfABodyAtRestHasTwoKeys) {
  const PlayedMotion motion(motion::FreeBody(Matrix3d::Identity(), Vector3d::Zero()), 1, 1e9);
  EXPECT_EQ(attitude_track(motion, 1e9, 1e-4).times, (std::vector<float>{0, 1e9F}));
}

// Each key is computed for the float32 time that is written, so that nothing is lost late in a
// motion, although float32 times are then 1e-3 s apart.
TEST(Track, LosesNothingLateInALongMotion) {
  const PlayedMotion motion = the_film();
  const Track track = attitude_track(motion, 10'000, 1e-4);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> time(9'000, 10'000);
  for (int i = 0; i < 1000; ++i) {
    const double t = time(random);
    EXPECT_LE(angle_between(played_rotation(track.times, track.rotations, t), motion.at(t).X),
              1e-4);
  }
}

TEST(Track, IsRefusedWhereFloat32TimesAreTooCoarse) {
  const PlayedMotion motion = the_film();
  for (const double end : {1e6, 1e9}) {
    try {
      attitude_track(motion, end, 1e-4);
      ADD_FAILURE() << end;
    } catch (const AccuracyError& error) {
      EXPECT_NE(std::string(error.what()).find("s apart"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(attitude_track(motion, 96, 9e-7), OutOfRange);
}

}  // namespace
}  // namespace twrench::interchange
