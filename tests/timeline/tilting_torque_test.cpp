#include "timeline/tilting_torque.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/rotating_frame.h>

#include <cmath>
#include <numeric>

namespace twrench::timeline {
namespace {

using Eigen::Vector3d;

scene::Scene wrench_about(const Vector3d& omega) {
  scene::Scene scene = scene::load_scene("dzhanibekov");
  scene.motion.omega = omega;
  return scene;
}

/// The built-in scenes whose bodies are rigid.
std::vector<scene::Scene> rigid_scenes() {
  std::vector<scene::Scene> scenes;
  for (const std::string& name : scene::builtin_scene_names()) {
    scene::Scene scene = scene::load_scene(name);
    if (scene.motion.is_rigid() && scene.overlay.compare_wheel.empty()) scenes.push_back(scene);
  }
  return scenes;
}

/// Returns the torque of the centrifugal and Coriolis forces on these parts about the axis of the
/// tilt.
double torque_on(const std::vector<body::Part>& parts, const motion::FreeBody& body,
                 const motion::Sample& sample) {
  const motion::RotatingFrame frame = motion::steady_frame(body, sample.t);
  const motion::FrameForces forces(frame, body, sample);
  const Vector3d axis =
      frame.attitude.transpose() * sample.X * motion::Tilt(body).direction(sample);
  double torque = 0;
  for (const body::Part& part : parts) {
    for (const auto& [mass, position] : body::equimomental_points(part)) {
      const motion::PointForces on = forces.on(mass, position);
      torque += axis.dot(on.position.cross(on.centrifugal + on.coriolis));
    }
  }
  return torque;
}

TEST(TiltingTorque, OfTheLegExceedsThatOfTheHandleWhereTheWrenchTiltsMore) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    scene::Scene scene = wrench_about({1, 1e-7, 0});
    for (body::Part& part : scene.body.parts) {
      auto& rod = std::get<body::Cylinder>(part.shape);
      rod.radius *= size;
      rod.length *= size;
      part.position *= size;
    }
    const motion::FreeBody body = scene::free_body(scene);
    const motion::Sample sample = motion::ExactMotion(body).at(20);
    const double unit = motion::Tilt(body).of(sample) * std::pow(size, 5);
    const TiltingTorque torque(scene, body);
    const auto groups = torque.on_groups(sample);
    ASSERT_EQ(groups.size(), 2U);
    EXPECT_EQ(groups[0].name, "handle");
    EXPECT_NEAR(groups[0].torque / unit, -270, 0.5) << "the handle pulls it back";
    EXPECT_NEAR(groups[1].torque / unit, 428, 0.5) << "the leg is flung out";
    const auto sides = torque.sides(sample);
    EXPECT_EQ(sides.further, groups[1].torque);
    EXPECT_EQ(sides.back, groups[0].torque);
    // The tilt accelerates accordingly: docs/theory.md.
    EXPECT_NEAR(sides.sum() / unit / 1161.44, std::pow(0.3683837, 2), 1e-5);
    EXPECT_EQ(torque.names(sample).further, "leg");
    EXPECT_EQ(torque.names(sample).back, "handle");
  }
}

// The handle and the leg, and the parts of the disc, are symmetric about the axes of the body, so
// no torque is left without a tilt.
TEST(TiltingTorque, OnAGroupIsThatOfTheForcesOnItsParts) {
  for (const Vector3d& omega : {Vector3d(1, 0.3, 0.2), {0.3, 1, -0.4}, {0.1, 0.3, 1}}) {
    for (const char* const name : {"dzhanibekov", "tao-disk"}) {
      scene::Scene scene = scene::load_scene(name);
      scene.motion.omega = omega;
      const motion::FreeBody body = scene::free_body(scene);
      const TiltingTorque torque(scene, body);
      const auto parts = scene::visible_parts(scene.body);
      const auto groups = scene::part_groups(scene.body);
      for (const double t : {0.0, 1.0, 3.0, 7.0, 12.0}) {
        const motion::Sample sample = motion::ExactMotion(body).at(t);
        const auto found = torque.on_groups(sample);
        ASSERT_EQ(found.size(), groups.size());
        for (std::size_t i = 0; i < groups.size(); ++i) {
          std::vector<body::Part> of_group;
          for (const std::size_t part : groups[i].parts) of_group.push_back(parts[part]);
          EXPECT_NEAR(found[i].torque, torque_on(of_group, body, sample), 1e-9) << groups[i].name;
        }
      }
    }
  }
}

TEST(TiltingTorque, OfAllGroupsTogetherIsThatOfTheForcesOnTheBody) {
  for (const scene::Scene& scene : rigid_scenes()) {
    const motion::FreeBody body = scene::free_body(scene);
    const TiltingTorque torque(scene, body);
    const double turn = 6.283 / std::max(body.omega().norm(), 1e-9);
    for (const double turns : {0.0, 0.7, 3.1, 8.8}) {
      const motion::Sample sample = motion::ExactMotion(body).at(turns * turn);
      const double size = body.inertia().norm() * body.omega().squaredNorm();
      EXPECT_NEAR(torque.sides(sample).sum(),
                  torque_on(scene::visible_parts(scene.body), body, sample), 1e-9 * size)
          << scene.name;
    }
  }
}

// Two rods at an angle hold each other in every rotation. Only the torques of the tilt are counted.
TEST(TiltingTorque, OmitsTheTorquesWithWhichPartsHoldEachOtherWithoutATilt) {
  scene::Scene scene;
  scene.body.parts = {
      {body::Cylinder{0.5, 8}, 6.7, {0, 0, 0}, so3::exp(Vector3d(0.9, 0.2, 0))},
      {body::Cylinder{1, 3}, 6.7, {1, 2, 0}, so3::exp(Vector3d(-0.4, 1, 0.3))},
  };
  const body::MassProperties properties = scene::mass_properties(scene.body);
  constexpr double tilt = 1e-6;
  for (const Vector3d& lean : {Vector3d(1, 0, 0), {0, 0, 1}, {-0.6, 0, 0.8}}) {
    Vector3d momentum = Vector3d::UnitY() + tilt * lean;
    const auto principal = body::principal_axes(properties.inertia);
    const Vector3d omega =
        principal.axes * momentum.cwiseQuotient(principal.moments) * principal.moments[1];
    const motion::FreeBody body(properties.inertia, omega);
    const motion::Sample sample = motion::ExactMotion(body).at(0);
    const auto sides = TiltingTorque(scene, body).sides(sample);
    const double size = properties.inertia.norm() * omega.squaredNorm();
    EXPECT_GT(sides.larger(), 1e-3 * tilt * size);
    EXPECT_LT(sides.larger(), 3 * tilt * size);
    const std::vector<body::Part> first{scene::visible_parts(scene.body)[0]};
    EXPECT_GT(std::abs(torque_on(first, body, sample)), 1e-3 * size);
  }
}

TEST(TiltingTorque, OfABodyOfOneGroupIsThatOfItsPointMasses) {
  for (const char* const name : {"phone", "book"}) {
    const scene::Scene scene = scene::load_scene(name);
    EXPECT_FALSE(TiltingTorque(scene, scene::free_body(scene)).compares_groups()) << name;
  }
  scene::Scene scene;
  scene.body.inertia = Vector3d(3, 4, 5).asDiagonal();
  scene.motion.omega = {0.1, 1, 0.1};
  const motion::FreeBody body = scene::free_body(scene);
  const TiltingTorque torque(scene, body);
  const motion::Sample sample = motion::ExactMotion(body).at(0.5);
  EXPECT_TRUE(torque.on_groups(sample).empty());
  EXPECT_TRUE(torque.names(sample).further.empty());
  EXPECT_GT(torque.sides(sample).further, 0.01);
  EXPECT_LT(torque.sides(sample).back, -0.01);
}

TEST(TiltingTorque, IsNoneOfABodyThatIsNotTilted) {
  const auto strongest = [](const scene::Scene& scene) {
    const motion::FreeBody body = scene::free_body(scene);
    std::vector<motion::Sample> samples;
    for (int i = 0; i < 100; ++i) samples.push_back(motion::ExactMotion(body).at(0.1 * i));
    return TiltingTorque(scene, body).strongest(samples);
  };
  EXPECT_EQ(strongest(scene::load_scene("sphere")), 0);
  EXPECT_EQ(strongest(wrench_about({0, 0, 0})), 0);
  EXPECT_EQ(strongest(wrench_about({0, 1, 0})), 0);
  EXPECT_EQ(strongest(wrench_about({0, 0, -1})), 0);
  EXPECT_GT(strongest(wrench_about({0, 1e-6, 1})), 0);
  // Rounding errors tilt this one.
  const Eigen::Matrix3d R = so3::exp(Vector3d(0.3, -1, 0.7));
  const Eigen::Matrix3d product = R * Vector3d(3, 4, 5).asDiagonal() * R.transpose();
  scene::Scene scene;
  scene.body.inertia = (product + product.transpose()) / 2;
  scene.motion.omega = R.col(1);
  const motion::FreeBody body = scene::free_body(scene);
  EXPECT_NE(TiltingTorque(scene, body).sides(motion::ExactMotion(body).at(3)).further, 0);
  EXPECT_EQ(strongest(scene), 0);
}

}  // namespace
}  // namespace twrench::timeline
