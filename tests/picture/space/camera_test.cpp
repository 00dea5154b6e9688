#include "picture/space/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::picture {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// Returns device coordinates: -1 to 1 from edge to edge, y upward.
Vector3d project(const Camera& camera, const Vector3d& point) {
  const Vector4d clip = camera.projection * camera.view * point.homogeneous();
  return clip.head<3>() / clip.w();
}

/// Returns the largest |x| and |y| of the sphere of `radius`, in device coordinates.
Vector2d reach(const Camera& camera, double radius) {
  Vector2d result(0, 0);
  for (int i = 0; i <= 180; ++i) {
    for (int j = 0; j < 360; ++j) {
      const double latitude = (i - 90) * std::numbers::pi / 180;
      const double longitude = j * std::numbers::pi / 180;
      const Vector3d point(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                           std::cos(latitude) * std::sin(longitude));
      result = result.cwiseMax(project(camera, radius * point).head<2>().cwiseAbs());
    }
  }
  return result;
}

class FramedSphere : public testing::TestWithParam<double> {};

TEST_P(FramedSphere, FillsTheNarrowerSideAndStaysInside) {
  const double aspect = GetParam();
  const Camera camera = frame_sphere({{3, 2, 7}, 0.55, aspect, 4.4});
  const Vector2d extent = reach(camera, 4.4);
  const double narrower = aspect >= 1 ? extent.y() : extent.x();
  const double wider = aspect >= 1 ? extent.x() : extent.y();
  EXPECT_LT(narrower, 0.99);
  EXPECT_GT(narrower, 0.90);
  EXPECT_NEAR(wider, narrower / std::max(aspect, 1 / aspect), 1e-3);  // a circle in the picture
}

INSTANTIATE_TEST_SUITE_P(Aspects, FramedSphere,
                         testing::Values(16.0 / 9, 9.0 / 16, 1.0, 4.0 / 3, 21.0 / 9));

/// Returns the extent of the points in device coordinates: left, right, bottom, top.
Eigen::Vector4d extent(const Camera& camera, const std::vector<Vector3d>& points) {
  Eigen::Vector4d e(1e9, -1e9, 1e9, -1e9);
  for (const Vector3d& point : points) {
    const Vector3d p = project(camera, point);
    e = Vector4d(std::min(e[0], p.x()), std::max(e[1], p.x()), std::min(e[2], p.y()),
                 std::max(e[3], p.y()));
  }
  return e;
}

TEST(Fitted, PutsThePointsAndTheSphereInTheMiddle) {
  const std::vector<Vector3d> points{{6, 0, 0}, {0, 0, 2}};
  for (const double aspect : {0.6, 1.0, 1.2, 3.0}) {
    const Framing framing = fitted({{0, 1, 4}, 0.55, aspect, 4}, {{Vector3d(0, 1, 4)}}, points);
    const Camera camera = frame_sphere(framing);
    std::vector<Vector3d> all = points;
    for (int i = 0; i < 360; ++i) {  // the sphere's outline lies close to this circle
      const double angle = i * std::numbers::pi / 180;
      all.emplace_back(4 * std::cos(angle), 4 * std::sin(angle) * 0.97, -1);
    }
    const Vector4d e = extent(camera, all);
    EXPECT_LT(e.cwiseAbs().maxCoeff(), 1) << aspect;
    EXPECT_NEAR(e[0] + e[1], 0, 0.1) << aspect;
    EXPECT_GT(e[1], aspect < 1.2 ? 0.85 : 0.2) << "as large as possible: " << aspect;
  }
}

TEST(Fitted, LeavesASphereAloneInTheMiddleAndAtItsDistance) {
  const Framing sphere{{3, 2, 7}, 0.55, 1.5, 4.4};
  const Framing framing = fitted(sphere, {{Vector3d(3, 2, 7)}}, {{Vector3d(1, 1, 1)}});
  EXPECT_EQ(framing.distance, 1);
  EXPECT_EQ(framing.centre, Vector2d(0, 0));
}

TEST(Fitted, HoldsWhatIsSeenFromAllDirections) {
  const std::vector<Vector3d> points{{6, 1, 0}};
  Framing framing{{0, 0, 1}, 0.55, 1.5, 4};
  const std::vector<Vector3d> directions = directions_along(0.3, 0.2, 20);
  framing = fitted(framing, directions, points);
  for (const Vector3d& direction : directions) {
    framing.direction = direction;
    EXPECT_LT(project(frame_sphere(framing), points[0]).head<2>().cwiseAbs().maxCoeff(), 0.98);
  }
}

TEST(DirectionsAlong, GoAroundOnceAtMost) {
  EXPECT_EQ(directions_along(0.5, 0.1, 0).size(), 1U);
  const auto part = directions_along(0.5, 0.1, -0.7);
  EXPECT_LT((part.front() - direction_of(0.5, 0.1)).norm(), 1e-15);
  EXPECT_LT((part.back() - direction_of(-0.2, 0.1)).norm(), 1e-15);
  const auto whole = directions_along(0.5, 0.1, 100);
  EXPECT_LT((whole.front() - whole.back()).norm(), 1e-14);
}

TEST(Camera, LooksAtTheOriginFromItsDirection) {
  const Camera camera = frame_sphere({{0, 5, 20}, 0.55, 1.5, 4});
  EXPECT_LT(project(camera, Vector3d::Zero()).head<2>().norm(), 1e-14);
  const Vector3d eye = camera.distance * Vector3d(0, 5, 20).normalized();
  EXPECT_LT((camera.view * eye.homogeneous() - Vector4d(0, 0, 0, 1)).norm(), 1e-13);
  EXPECT_LT(project(camera, 0.1 * eye).z(), project(camera, -0.1 * eye).z());  // nearer is less
}

TEST(Camera, ShowsSpaceUpwardAndNotMirrored) {
  const Camera camera = frame_sphere({{0, 0, 1}, 0.55, 1.5, 4});
  EXPECT_GT(project(camera, Vector3d::UnitX()).x(), 0);
  EXPECT_GT(project(camera, Vector3d::UnitY()).y(), 0);
  const Eigen::Matrix3d rotation = camera.camera_from_space();
  EXPECT_LT((rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_NEAR(rotation.determinant(), 1, 1e-15);
}

TEST(Camera, SeesTheAngleOfViewOnTheNarrowerSide) {
  const Camera wide = frame_sphere({{0, 0, 1}, 0.8, 2.0, 1});
  EXPECT_NEAR(wide.projection(1, 1), 1 / std::tan(0.4), 1e-15);
  const Camera tall = frame_sphere({{0, 0, 1}, 0.8, 0.5, 1});
  EXPECT_NEAR(tall.projection(0, 0), 1 / std::tan(0.4), 1e-15);
}

TEST(Camera, IsDefinedStraightFromAboveAndBelow) {
  for (const double side : {-1.0, 1.0}) {
    const Camera camera = frame_sphere({{0, side, 0}, 0.55, 1.0, 1});
    EXPECT_TRUE(camera.view.allFinite());
    EXPECT_NEAR(camera.camera_from_space().determinant(), 1, 1e-15);
    EXPECT_GT(project(camera, -side * Vector3d::UnitZ()).y(), 0);
  }
}

TEST(Camera, CarriedByAFrameSeesThePointsThatAreAtRestThere) {
  const Camera fixed = frame_sphere({{1, 2, 5}, 0.6, 4.0 / 3, 1.5});
  const Eigen::Matrix3d F = Eigen::AngleAxisd(2, Vector3d(1, 2, -3).normalized()).matrix();
  const Vector3d point(0.3, -0.5, 0.8);
  EXPECT_LT((project(carried(fixed, F), F * point) - project(fixed, point)).norm(), 1e-14);
  EXPECT_EQ(carried(fixed, F).distance, fixed.distance);
}

}  // namespace
}  // namespace twrench::picture
