#include "picture/body/occluders.h"

#include <gtest/gtest.h>

#include "picture/body/meshes.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

TEST(CapsulesOf, LiesAboutTheLongestAxis) {
  const Capsule capsule = capsules_of(cylinder(1, 8, {-1, 0, 0}, Vector3d::UnitY()))[0];
  EXPECT_EQ(capsule.radius, 1);
  EXPECT_NEAR((capsule.from - Vector3d(-1, -3.5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((capsule.to - Vector3d(-1, 3.5, 0)).norm(), 0, 1e-12);
  const Capsule box =
      capsules_of({body::Box{{6, 2, 4}}, 1, {0, 0, 1}, Eigen::Matrix3d::Identity()})[0];
  EXPECT_EQ(box.radius, 1.5);
  EXPECT_NEAR(std::abs((box.to - box.from).x()), 4.5, 1e-12);
}

TEST(CapsulesOf, IsABallForABall) {
  const Capsule capsule = capsules_of(
      {body::Ellipsoid{Vector3d::Constant(2)}, 1, {1, 2, 3}, Eigen::Matrix3d::Identity()})[0];
  EXPECT_EQ(capsule.radius, 2);
  EXPECT_NEAR((capsule.to - capsule.from).norm(), 2, 1e-12);
}

// A capsule about a disc would darken the half of a ball that lies on it.
TEST(Neighbours, AreNoPlates) {
  const auto occluders_of_ball_on = [](double thickness) {
    const body::Part ball{
        body::Ellipsoid{Vector3d::Constant(0.3)}, 1, {0.5, 0, 0.3}, Eigen::Matrix3d::Identity()};
    return find_occluders(
               std::vector{cylinder(1, thickness, {0, 0, -thickness / 2}, Vector3d::UnitZ()), ball},
               3)[1]
        .size();
  };
  EXPECT_EQ(occluders_of_ball_on(0.2), 0U);
  EXPECT_EQ(occluders_of_ball_on(1), 1U);
  EXPECT_EQ(occluders_of_ball_on(20), 1U) << "a rod";
}

TEST(Neighbours, AreNoFoil) {
  const auto occluders = [](double shell) {
    const body::Part ball{
        body::Ellipsoid{Vector3d::Constant(1)}, 1, {0.5, 0.5, -1.01}, Eigen::Matrix3d::Identity()};
    const body::Part sheet =
        part_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}}, shell);
    return find_occluders(std::vector{ball, sheet}, 3);
  };
  EXPECT_TRUE(occluders(0.001)[0].empty() && occluders(0.001)[1].empty());
  EXPECT_FALSE(occluders(0.01)[0].empty() || occluders(0.01)[1].empty()) << "a wall";
}

TEST(Neighbours, AreNotHiddenInside) {
  const auto occluders_of_ball_around = [](const Vector3d& centre) {
    const auto ball = [](double radius, const Vector3d& middle) {
      return body::Part{body::Ellipsoid{Vector3d::Constant(radius)}, 1, middle,
                        Eigen::Matrix3d::Identity()};
    };
    return find_occluders(std::vector{ball(2, {0, 0, 0}), ball(0.5, centre)}, 3)[0].size();
  };
  EXPECT_EQ(occluders_of_ball_around({0, 1.2, 0}), 0U);
  EXPECT_EQ(occluders_of_ball_around({0, 2, 0}), 1U) << "half of it sticks out";
}

TEST(Neighbours, AreTheNearestThatAreNear) {
  const std::vector<body::Part> parts{cylinder(1, 8, {0, 0, 0}, Vector3d::UnitY()),
                                      cylinder(1, 4, {3.0, 2, 0}, Vector3d::UnitX()),
                                      cylinder(0.5, 4, {0, 0, 2.6}, Vector3d::UnitZ()),
                                      cylinder(1, 4, {90, 0, 0}, Vector3d::UnitX())};
  const auto found = find_occluders(parts, 3);
  ASSERT_EQ(found.size(), 4U);
  ASSERT_EQ(found[0].size(), 2U);
  EXPECT_EQ(found[0][0].radius, 0.5) << "the nearest first";
  EXPECT_EQ(found[0][1].radius, 1);
  EXPECT_TRUE(found[3].empty()) << "far from all others";
  EXPECT_EQ(find_occluders(parts, 1)[0].size(), 1U);
}

}  // namespace
}  // namespace twrench::picture
