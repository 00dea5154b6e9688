#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "mesh/topology.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;

/// A triangle at an edge, at an angle about it in degrees.
struct Turn {
  double angle;
  bool is_forward;
};

constexpr bool forward = true, backward = false;

/// Places an edge of length 2 and the triangles, and returns whether they bound a solid.
bool is_solid(const std::vector<Turn>& turns,
              const Eigen::Isometry3d& place = Eigen::Isometry3d::Identity()) {
  body::TriangleMesh mesh;
  mesh.vertices = {place * Vector3d(0, 0, 0), place * Vector3d(0, 0, 2)};
  std::vector<EdgeTriangle> triangles;
  for (const auto& [degrees, is_forward] : turns) {
    const double angle = degrees * std::numbers::pi / 180, size = 1 + angle, height = 3 - angle;
    triangles.push_back({static_cast<std::uint32_t>(mesh.vertices.size()), is_forward});
    mesh.vertices.push_back(place *
                            Vector3d(size * std::cos(angle), size * std::sin(angle), height));
  }
  return bounds_solid(mesh, 0, 1, triangles);
}

TEST(EdgeOrder, OfSolidsThatTouchAlternates) {
  const std::vector<Turn> two{{0, forward}, {90, backward}, {180, forward}, {270, backward}};
  const std::vector<Turn> three{{300, backward}, {10, forward},   {200, backward},
                                {250, forward},  {100, backward}, {110, forward}};
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.rotate(Eigen::AngleAxisd(2, Vector3d(1, 2, 3).normalized()));
  place.pretranslate(Vector3d(300, -100, 20));
  for (const auto& turns : {two, three}) {
    EXPECT_TRUE(is_solid(turns));
    EXPECT_TRUE(is_solid(turns, place));
  }
}

TEST(EdgeOrder, OfSolidsThatOverlapDoesNot) {
  EXPECT_FALSE(is_solid({{0, forward}, {60, forward}, {90, backward}, {150, backward}}));
  EXPECT_FALSE(is_solid({{0, forward}, {0, forward}, {90, backward}, {90, backward}})) << "twice";
  EXPECT_FALSE(is_solid({{0, forward}, {30, forward}, {60, backward}, {90, backward}}))
      << "one within another";
  EXPECT_FALSE(is_solid({{0, forward}, {90, backward}, {180, backward}, {270, forward}}))
      << "one is turned over";
}

TEST(EdgeOrder, OfFacesThatLieOnEachOtherDoesNotMatter) {
  for (const double rounding : {0.0, 1e-5, -1e-5}) {
    const double at = 90 + rounding, end = rounding > 0 ? rounding : 360 + rounding;
    EXPECT_TRUE(is_solid({{0, forward}, {90, backward}, {at, forward}, {180, backward}}));
    EXPECT_TRUE(is_solid({{0, forward}, {at, forward}, {90, backward}, {180, backward}}));
    EXPECT_TRUE(is_solid({{0, forward}, {90, backward}, {90, forward}, {end, backward}}));
    EXPECT_TRUE(is_solid({{0, forward},
                          {90, backward},
                          {at, forward},
                          {180, backward},
                          {180, forward},
                          {270, backward},
                          {270, forward},
                          {end, backward}}))
        << "four around the edge";
  }
  EXPECT_FALSE(is_solid({{0, forward}, {89, forward}, {90, backward}, {180, backward}}));
}

TEST(EdgeOrder, OfATriangleWithoutAreaIsUnknown) {
  body::TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {0, 0, 2}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 0.5}};
  const std::vector<EdgeTriangle> triangles{
      {2, forward}, {3, backward}, {4, forward}, {5, backward}};
  EXPECT_FALSE(bounds_solid(mesh, 0, 1, triangles));
}

}  // namespace
}  // namespace twrench::mesh
