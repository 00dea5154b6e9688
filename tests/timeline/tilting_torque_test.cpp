#include "timeline/tilting_torque.h"

#include <gtest/gtest.h>
#include <twrench/motion/exact.h>

#include <cmath>

namespace twrench::timeline {
namespace {

TEST(TiltingTorque, OfTheLegExceedsThatOfTheHandleWhereTheWrenchTiltsMore) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.motion.omega = {1, 1e-7, 0};
  scene.camera.frame = scene::Frame::rotating;
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const motion::Sample sample = motion::ExactMotion(body).at(20);
  const double tilt = motion::Tilt(body).of(sample);
  const auto torques = TiltingTorque(scene, body).on_groups(sample);
  ASSERT_EQ(torques.size(), 2U);
  EXPECT_NEAR(torques[0] / tilt, -270, 0.5) << "the handle pulls it back";
  EXPECT_NEAR(torques[1] / tilt, 428, 0.5) << "the leg is flung out";
  // The tilt accelerates accordingly: docs/theory.md.
  EXPECT_NEAR((torques[0] + torques[1]) / tilt / 1161.44, std::pow(0.3683837, 2), 1e-5);
}

TEST(TiltingTorque, IsBalancedInTheFrameOfTheBody) {
  scene::Scene scene = scene::load_scene("tao-disk");
  scene.camera.frame = scene::Frame::body;
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const auto torques = TiltingTorque(scene, body).on_groups(motion::ExactMotion(body).at(7));
  ASSERT_EQ(torques.size(), 3U);
  EXPECT_GT(std::abs(torques[1]), 1);
  EXPECT_NEAR(torques[0] + torques[1] + torques[2], 0, 1e-9) << "everything is at rest there";
}

}  // namespace
}  // namespace twrench::timeline
