#include "picture/body/revolution.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <vector>

#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Vector3d slanted = Vector3d(1, 2, -2) / 3;

body::Part ellipsoid(const Vector3d& radii, const Vector3d& position) {
  return {body::Ellipsoid{radii}, 1.0, position, body::frame_with_z_along(slanted)};
}

void expect_axis(const std::vector<body::Part>& parts) {
  const auto axis = axis_of_revolution(parts);
  ASSERT_TRUE(axis.has_value());
  EXPECT_NEAR(std::abs(axis->dot(slanted)), 1, 1e-9);
}

TEST(AxisOfRevolution, IsThatOfOnePart) {
  expect_axis({cylinder(1, 2, {0, 0, 0}, slanted)});
  expect_axis({ellipsoid({2, 2, 1}, {0, 0, 0})});
  EXPECT_TRUE(axis_of_revolution(std::vector{ellipsoid({2, 2, 2}, {0, 0, 0})}).has_value());
}

TEST(AxisOfRevolution, IsSharedByAllParts) {
  expect_axis({cylinder(3, 1, 2 * slanted, slanted), cylinder(1, 5, -slanted, -slanted),
               ellipsoid({2, 2, 1}, {0, 0, 0})});
  expect_axis({ellipsoid({1, 1, 1}, 3 * slanted), ellipsoid({2, 2, 2}, -slanted)});
}

TEST(AxisOfRevolution, IsThatOfEachSolidOfRevolution) {
  const Matrix3d turn = body::frame_with_z_along(slanted);
  for (const body::Shape& shape :
       {body::Shape{body::Cone{2, 3, 1}}, body::Shape{body::Torus{3, 1}},
        body::Shape{body::Capsule{1, 4}}, body::Shape{body::Tube{2, 1, 3}}}) {
    expect_axis({{shape, 1, 2 * slanted, turn}});
  }
}

TEST(AxisOfRevolution, IsNotThereForBodiesThatShowHowTheyTurn) {
  const std::vector<std::vector<body::Part>> bodies{
      t_wrench().body.parts,
      {{body::Box{{2, 2, 3}}, 1.0, {0, 0, 0}, Matrix3d::Identity()}},
      {ellipsoid({1, 2, 3}, {0, 0, 0})},
      {cylinder(1, 2, {0.01, 0, 0}, Vector3d::UnitY())},  // beside the axis of the rotation
      {cylinder(1, 2, slanted, slanted), cylinder(1, 2, -slanted, Vector3d::UnitX())}};
  for (const auto& parts : bodies) EXPECT_FALSE(axis_of_revolution(parts).has_value());
}

Eigen::Vector2f across(const AcrossFromBody& rows, const Vector3d& place) {
  const auto row = [&](std::size_t i) {
    const Vector3d axis(rows[i].x, rows[i].y, rows[i].z);
    return static_cast<float>(axis.dot(place)) + rows[i].w;
  };
  return {row(0), row(1)};
}

TEST(AcrossFromBody, MeasuresFromACylindersAxisInItsRadii) {
  const auto rows = across_from_body(t_wrench().body.parts);
  EXPECT_NEAR(across(rows[0], {-1, 3, 0}).norm(), 0, 1e-6) << "on the handle's axis";
  EXPECT_NEAR(across(rows[0], {0, 3, 0}).norm(), 1, 1e-6);
  EXPECT_NEAR(across(rows[1], {3, 0, 0.5}).norm(), 0.5, 1e-6);
  const body::Part box{body::Box{{1, 1, 1}}, 1.0, {0, 0, 0}, Matrix3d::Identity()};
  EXPECT_EQ(across_from_body(std::vector{box}).front(), AcrossFromBody{});
}

TEST(AcrossFromBody, IsTheSameForAllPartsOfABodyOfRevolution) {
  const auto rows = across_from_body(
      std::vector{cylinder(1, 9, {0, 0, 0}, slanted), ellipsoid({4, 4, 1}, {0, 0, 0})});
  EXPECT_EQ(rows[0], rows[1]);
  EXPECT_NEAR(across(rows[0], 5 * slanted + 2 * slanted.unitOrthogonal()).norm(), 0.5, 1e-6);
}

}  // namespace
}  // namespace twrench::picture
