// The motion of a body without a closed form, as the page's core computes it.
#include "integrated_motion.h"

#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/motion/exact.h>

#include <cmath>
#include <vector>

#include "motion/reference.h"
#include "page/page_html.h"
#include "study/reference.h"

namespace twrench::page {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using motion::FreeBody;

FreeBody with_wheel(const Vector3d& moments, const Vector3d& omega, const Vector3d& wheel) {
  return {moments.asDiagonal(), omega, Matrix3d::Identity(), {.wheel = wheel}};
}

TEST(IntegratedMotion, AgreesWithTheReferenceInAnyOrder) {
  for (const motion::ReferenceCase& c : motion::constant_momentum_cases()) {
    IntegratedMotion forward(c.body), backward(c.body);
    backward.at(c.samples.back().t + 1);
    for (auto sample = c.samples.rbegin(); sample != c.samples.rend(); ++sample) {
      backward.at(sample->t);
    }
    for (const motion::Sample& expected : c.samples) {
      const motion::Sample sample = forward.at(expected.t);
      EXPECT_LE((sample.X - expected.X).norm(), 1e-12) << c.name << ", t = " << expected.t;
      EXPECT_LE((sample.omega - expected.omega).norm(), 1e-12) << c.name << ", t = " << expected.t;
      EXPECT_EQ(sample.X, backward.at(expected.t).X) << c.name << ", t = " << expected.t;
    }
    EXPECT_EQ(forward.at(0).X, Matrix3d::Identity());
    EXPECT_EQ(forward.at(0).omega, c.body.initial_rate());
  }
}

TEST(IntegratedMotion, IsThatOfTheMethodTaylor) {
  const FreeBody body = with_wheel({3, 4, 5}, {0.1, 1, 0.2}, {0.3, 0.2, -0.1});
  const std::vector<double> times{0.01, 7, 7.5, 300};
  IntegratedMotion motion(body);
  for (const motion::Sample& expected : study::reference_at(body, times)) {
    EXPECT_EQ(motion.at(expected.t).X, expected.X) << expected.t;
  }
}

TEST(IntegratedMotion, HasAnEnd) {
  IntegratedMotion motion(with_wheel({3, 4, 5}, {0.1, 1, 0.2}, {0.3, 0.2, -0.1}));
  EXPECT_GT(motion.longest(), 1e4);
  EXPECT_TRUE(motion.at(motion.longest()).X.allFinite());
  for (const double t : {-1e-9, 1.01 * motion.longest(), std::nan("")}) {
    EXPECT_THROW(motion.at(t), OutOfRange) << t;
  }
}

TEST(IntegratedMotion, HasTheFlipsOfAStudy) {
  const FreeBody body = with_wheel({3, 4, 5}, {0.01, 1, 0.02}, {0, 0.2, 0});
  const std::vector<double> expected = study::reference_flip_times(body, 200);
  ASSERT_GE(expected.size(), 4U);
  ASSERT_TRUE(turns_over(body));
  IntegratedMotion motion(body);
  for (std::size_t n = expected.size(); n-- > 0;) {
    EXPECT_NEAR(motion.flip(n).value(), expected[n], 1e-9) << n;
    EXPECT_EQ(motion.flips_until(expected[n] + 1e-6), n + 1);
    EXPECT_EQ(motion.flips_until(expected[n] - 1e-6), n);
  }
  IntegratedMotion held(with_wheel({3, 4, 5}, {0.01, 1, 0.02}, {0, 3, 0}));
  EXPECT_FALSE(held.flip(0));
}

/// A tiny wheel changes nothing; one above the threshold (I3 - I2) omega holds the rotation.
TEST(TurningOver, DependsOnTheWheel) {
  const Vector3d moments(3, 4, 5);
  for (const Vector3d& omega :
       {Vector3d(0.01, 1, 0.02), Vector3d(0.3, 1, 0.2), Vector3d(1e-5, 1, 0),
        Vector3d(0.01, 0.02, 1), Vector3d(1, 0.3, 0)}) {
    const auto flips = motion::ExactMotion({moments.asDiagonal(), omega}).flips();
    EXPECT_EQ(turns_over(with_wheel(moments, omega, {0, 1e-6, 0})), flips->turns_over())
        << omega.transpose();
    EXPECT_FALSE(turns_over(with_wheel(moments, omega, {0, 3 * omega[1], 0}))) << omega.transpose();
  }
  EXPECT_FALSE(turns_over(with_wheel(moments, {0, 1, 0}, {0, 0.1, 0}))) << "steady";
  EXPECT_FALSE(turns_over(with_wheel({3, 3, 5}, {0.01, 1, 0.02}, {0, 0.1, 0.1}))) << "no middle";
  EXPECT_FALSE(turns_over(with_wheel(moments, {0, 1, 0}, {0, -4, 0}))) << "L = 0";
  EXPECT_FALSE(turns_over(
      {moments.asDiagonal(), {0.01, 1, 0.02}, Matrix3d::Identity(), {.energy_loss_time = 50}}));
}

TEST(ShownScene, HasTheLastOfTheComparedWheels) {
  for (const auto& [name, wheel] :
       {std::pair("dual-spin", 4e7), std::pair("t-handle-wheel", 6000.0)}) {
    scene::Scene scene = scene::load_scene(name);
    ASSERT_FALSE(scene.motion.wheel);
    EXPECT_EQ(shown_scene(scene).motion.wheel, Vector3d(wheel, 0, 0)) << name;
    scene.motion.wheel = Vector3d(1, 2, 3);
    EXPECT_EQ(shown_scene(scene).motion.wheel, Vector3d(1, 2, 3)) << name;
  }
  EXPECT_FALSE(shown_scene(scene::load_scene("dzhanibekov")).motion.wheel);
}

}  // namespace
}  // namespace twrench::page
