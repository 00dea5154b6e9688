// The motion between recorded instants, against the exact motion.
#include "motion/recorded_motion.h"

#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/bodies_of_every_kind.h"

namespace twrench::motion {
namespace {

using Eigen::Vector3d;

RecordedMotion recorded(const ExactMotion& motion, double step, int count) {
  std::vector<RecordedMotion::Instant> instants;
  for (int i = 0; i <= count; ++i) {
    const Sample sample = motion.at(i * step);
    instants.push_back({sample.t, sample.quaternion(), sample.omega});
  }
  return {std::move(instants), 2 * step};
}

struct Errors {
  double attitude = 0, rate = 0;
};

/// The largest errors halfway and elsewhere between the instants.
Errors errors_of(const ExactMotion& motion, const RecordedMotion& between, double step, int count) {
  Errors errors;
  for (int i = 0; i < 7 * count; ++i) {
    const double t = (i + 0.5) * step / 7;
    const Sample is = between.at(t), ought = motion.at(t);
    errors.attitude = std::max(errors.attitude, so3::log(ought.X.transpose() * is.X).norm());
    errors.rate = std::max(errors.rate, (is.omega - ought.omega).norm());
  }
  return errors;
}

TEST(RecordedMotion, HasOrderFourInAttitudeAndThreeInRate) {
  const ExactMotion motion(FreeBody(Vector3d(2, 3, 4.5).asDiagonal(), Vector3d(0.3, 2, 0.4)));
  const double step = 0.02;
  const Errors coarse = errors_of(motion, recorded(motion, step, 100), step, 100);
  const Errors fine = errors_of(motion, recorded(motion, step / 2, 200), step / 2, 200);
  EXPECT_NEAR(std::log2(coarse.attitude / fine.attitude), 4, 0.1);
  EXPECT_NEAR(std::log2(coarse.rate / fine.rate), 3, 0.1);
  EXPECT_LT(coarse.attitude, 1e-7);
}

TEST(RecordedMotion, MeetsAttitudesAndRatesAtEveryInstantOfEveryKindOfBody) {
  for (const auto& [moments, omega] : bodies_of_every_kind()) {
    const ExactMotion motion(FreeBody(moments.asDiagonal(), omega));
    const double step = 0.3 / std::max(omega.norm(), 1e-3);
    const RecordedMotion between = recorded(motion, step, 20);
    const double speed = std::max(omega.norm(), 1e-3);
    for (const RecordedMotion::Instant& instant : between.instants()) {
      // Just before the instant the polynomial ends; at it the next begins.
      for (const double t : {instant.t * (1 - 1e-14), instant.t}) {
        const Sample sample = between.at(t);
        const Eigen::Quaterniond X(instant.X);
        EXPECT_LT(so3::log(X.toRotationMatrix().transpose() * sample.X).norm(), 1e-12);
        EXPECT_LT((sample.omega - instant.omega).norm() / speed, 1e-11) << moments << omega;
      }
    }
  }
}

TEST(RecordedMotion, IsHeldInGapsAndBeyondItsEnds) {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
  const Vector3d omega(0.1, 0, 0);
  const RecordedMotion motion({{5, Eigen::Quaterniond::Identity(), omega},
                               {6, turned, omega},
                               {16, turned * turned, omega},
                               {17, turned * turned * turned, omega}},
                              4);
  EXPECT_EQ(motion.duration(), 12);
  EXPECT_EQ(motion.at(-1).X, Eigen::Matrix3d::Identity());
  EXPECT_EQ(motion.at(7).X, turned.toRotationMatrix());
  EXPECT_EQ(motion.at(10.999).X, turned.toRotationMatrix());
  EXPECT_EQ(motion.at(20).X, motion.at(12).X);
  EXPECT_TRUE(motion.is_in_gap(1.5));
  EXPECT_FALSE(motion.is_in_gap(1));
  EXPECT_FALSE(motion.is_in_gap(11));
  EXPECT_FALSE(motion.is_in_gap(0.5));
  const auto angle = [](const Sample& s) { return so3::log(s.X).norm(); };
  EXPECT_NEAR(angle(motion.at(0.5)), 0.05, 1e-15);
}

TEST(RecordedMotion, BoundsRatesAndAccelerations) {
  for (const auto& [moments, omega] : bodies_of_every_kind()) {
    const ExactMotion motion(FreeBody(moments.asDiagonal(), omega));
    const double step = 0.5 / std::max(omega.norm(), 1e-3), h = 1e-3 * step;
    const RecordedMotion between = recorded(motion, step, 20);
    for (int i = 0; i < 100; ++i) {
      const double t = (i + 0.5) * step / 5;
      const auto [velocity, acceleration] = between.rates_between(t - h, t + h);
      const Sample before = between.at(t - h), after = between.at(t + h);
      EXPECT_LE(between.at(t).omega.norm(), velocity);
      EXPECT_LE((after.omega - before.omega).norm() / (2 * h), acceleration * (1 + 1e-3) + 1e-9);
    }
  }
}

TEST(RecordedMotion, IsThinnedWithinAnAngle) {
  for (const auto& [moments, omega] : bodies_of_every_kind()) {
    const ExactMotion motion(FreeBody(moments.asDiagonal(), omega));
    const RecordedMotion all = recorded(motion, 0.01 / std::max(omega.norm(), 1e-3), 500);
    for (const double angle : {1e-8, 1e-4}) {
      const RecordedMotion few = all.thinned(angle);
      EXPECT_LT(few.instants().size(), 250U) << moments << omega;
      EXPECT_FALSE(few.has_gaps());
      EXPECT_EQ(few.duration(), all.duration());
      for (const RecordedMotion::Instant& instant : all.instants()) {
        const Eigen::Matrix3d X = Eigen::Quaterniond(instant.X).toRotationMatrix();
        EXPECT_LE(so3::log(X.transpose() * few.at(instant.t).X).norm(), angle + 1e-15);
      }
    }
  }
}

TEST(RecordedMotion, KeepsItsGapsWhenThinned) {
  const ExactMotion motion(FreeBody(Vector3d(2, 3, 4.5).asDiagonal(), Vector3d(0.05, 2, 0.03)));
  std::vector<RecordedMotion::Instant> instants;
  for (int i = 0; i <= 400; ++i) {
    const bool is_lost = (i > 100 && i < 112) || (i > 300 && i < 350);
    const Sample sample = motion.at(0.01 * i);
    if (!is_lost) instants.push_back({sample.t, sample.quaternion(), sample.omega});
  }
  const RecordedMotion all(std::move(instants), 0.04), few = all.thinned(1e-3);
  EXPECT_LT(few.instants().size(), all.instants().size() / 2);
  for (int i = 0; i < 4000; ++i) {
    const double t = (i + 0.5) * 1e-3;
    EXPECT_EQ(few.is_in_gap(t), all.is_in_gap(t)) << t;
    EXPECT_LE(so3::log(all.at(t).X.transpose() * few.at(t).X).norm(), 1e-3);
  }
}

TEST(RecordedMotion, RefusesASingleInstant) {
  EXPECT_THROW(RecordedMotion({{0, Eigen::Quaterniond::Identity(), Vector3d::Zero()}}, 1),
               InvalidArgument);
}

}  // namespace
}  // namespace twrench::motion
