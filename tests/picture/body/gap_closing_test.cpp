#include "picture/body/gap_closing.h"

#include <gtest/gtest.h>

#include <vector>

#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

double length_of(const body::Part& part) { return std::get<body::Cylinder>(part.shape).length; }

TEST(JoinedParts, CarriesTheLegOnToTheHandlesAxis) {
  const auto parts = close_gaps(t_wrench().body.parts);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(length_of(parts[0]), 8);
  EXPECT_EQ(parts[0].position, Vector3d(-1, 0, 0));
  EXPECT_NEAR(length_of(parts[1]), 5, 1e-12);  // from x = 4 to x = -1, no longer to 0
  EXPECT_LT((parts[1].position - Vector3d(1.5, 0, 0)).norm(), 1e-12);
}

TEST(JoinedParts, JoinsEitherEnd) {
  auto given = t_wrench().body.parts;
  given[1].body_from_part = body::frame_with_z_along(-Vector3d::UnitX());
  const auto parts = close_gaps(given);
  EXPECT_NEAR(length_of(parts[1]), 5, 1e-12);
  EXPECT_LT((parts[1].position - Vector3d(1.5, 0, 0)).norm(), 1e-12);
}

TEST(JoinedParts, CarriesARodIntoABall) {
  const body::Part ball{body::Ellipsoid{{2, 2, 2}}, 1.0, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  const auto parts = close_gaps(std::vector{ball, cylinder(0.5, 4, {4, 0, 0}, Vector3d::UnitX())});
  EXPECT_NEAR(length_of(parts[1]), 6, 1e-12);
}

TEST(JoinedParts, LeavesPartsThatDoNotTouch) {
  auto given = t_wrench().body.parts;
  given[1].position.x() += 0.1;
  EXPECT_EQ(length_of(close_gaps(given)[1]), 4);
}

TEST(JoinedParts, LeavesPartsThatAlreadyOverlap) {
  auto given = t_wrench().body.parts;
  given[1].position.x() -= 0.5;
  EXPECT_EQ(length_of(close_gaps(given)[1]), 4);
}

TEST(JoinedParts, LeavesAnEndThatWouldShowOnTheOtherSide) {
  auto given = t_wrench().body.parts;
  std::get<body::Cylinder>(given[1].shape).radius = 1.5;
  EXPECT_EQ(length_of(close_gaps(given)[1]), 4);
}

TEST(JoinedParts, LeavesADiscThatIsWiderThanTheRodItSitsOn) {
  const auto parts = close_gaps(std::vector{cylinder(1, 8, {0, 0, 0}, Vector3d::UnitZ()),
                                            cylinder(3, 1, {0, 0, 4.5}, Vector3d::UnitZ())});
  EXPECT_EQ(length_of(parts[1]), 1);
  EXPECT_NEAR(length_of(parts[0]), 8.5, 1e-12);  // the rod extends into the disc instead
}

TEST(JoinedParts, CarriesARodIntoRoundShapes) {
  const Eigen::Matrix3d upright = body::frame_with_z_along(Vector3d::UnitY());
  const auto length_into = [&](const body::Shape& shape) {
    const std::vector<body::Part> parts{cylinder(0.1, 4, {4, 0, 0}, Vector3d::UnitX()),
                                        {shape, 1, {0, 0, 0}, upright}};
    return std::get<body::Cylinder>(close_gaps(parts)[0].shape).length;
  };
  EXPECT_NEAR(length_into(body::Capsule{2, 3}), 6, 1e-9) << "up to the axis";
  EXPECT_NEAR(length_into(body::Cone{3, 4, 1}), 6, 1e-9);
  EXPECT_NEAR(length_into(body::Tube{2, 1.4, 3}), 4.3, 1e-9) << "up to the middle of the wall";
  EXPECT_NEAR(length_into(body::Torus{1.6, 0.4}), 4.4, 1e-9);
}

}  // namespace
}  // namespace twrench::picture
