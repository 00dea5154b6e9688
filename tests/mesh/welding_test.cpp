#include "mesh/welding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>

#include <cmath>
#include <random>

#include "mesh/samples.h"
#include "sanitizers.h"

namespace twrench::mesh {
namespace {

using body::TriangleMesh;
using Eigen::Vector3d;
using testing::ElementsAre;

/// Returns the mesh with three separate vertices for each triangle, each moved by less than `by`.
TriangleMesh exploded(const TriangleMesh& mesh, double by) {
  std::mt19937 random(5);
  const auto part = [&] { return by * (static_cast<double>(random()) * 0x1p-32 - 0.5); };
  TriangleMesh soup;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.size());
    soup.triangles.push_back({first, first + 1, first + 2});
    for (const std::uint32_t corner : triangle) {
      soup.vertices.emplace_back(mesh.vertices[corner] + Vector3d(part(), part(), part()));
    }
  }
  return soup;
}

// Comparing each with all others would take hours.
TEST(Weld, RefusesVerticesThatAreAllCloseToEachOther) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  std::mt19937 random(5);
  const auto part = [&] { return static_cast<double>(random()) * 0x1p-32; };
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 150'000; ++i) {
    mesh.vertices.emplace_back(part(), part(), part());
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  EXPECT_THROW(weld(mesh, 2), InvalidArgument);
}

TEST(Weld, JoinsEqualVertices) {
  TriangleMesh mesh = exploded(ball_with_open_poles(80, 40, 0), 0);
  const Welded welded = weld(mesh, 0);
  EXPECT_EQ(welded.joined_vertices, 0U) << "none were apart";
  EXPECT_EQ(welded.removed_triangles, 0U);
  EXPECT_EQ(mesh.vertices.size(), 39 * 80 + 2U);
  EXPECT_EQ(mesh.triangles.size(), 2 * 39 * 80U);
}

TEST(Weld, TakesTheTwoZerosForOne) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, -0.0, 0}}, {{0, 1, 2}, {3, 2, 1}}, {}};
  weld(mesh, 0);
  EXPECT_EQ(mesh.vertices.size(), 3U);
}

TEST(Weld, JoinsWhatIsNoFartherApartThanTheTolerance) {
  const TriangleMesh whole = ball_with_open_poles(80, 40, 0);
  TriangleMesh mesh = exploded(whole, 1e-6);
  const Welded welded = weld(mesh, 2e-6);
  EXPECT_EQ(mesh.vertices.size(), 39 * 80 + 2U);
  EXPECT_EQ(welded.joined_vertices, 3 * whole.triangles.size() - mesh.vertices.size());
  EXPECT_EQ(weld(mesh, 2e-6).joined_vertices, 0U) << "again";
  EXPECT_GT(weld(mesh, 0.1).removed_triangles, 100U) << "more than its edges at the poles";
}

TEST(Weld, JoinsVerticesThatAreExactlyTheToleranceApart) {
  const auto vertices_left = [](double distance) {
    TriangleMesh mesh{
        {{0, 0, 0}, {distance, 0, 0}, {5, 0, 0}, {0, 5, 0}}, {{0, 2, 3}, {1, 2, 3}}, {}};
    weld(mesh, 0.5);
    return mesh.vertices.size();
  };
  EXPECT_EQ(vertices_left(0.5), 3U);
  EXPECT_EQ(vertices_left(std::nextafter(0.5, 1)), 4U);
}

TEST(Weld, JoinsFromOneToTheNext) {
  TriangleMesh mesh{{{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {5, 0, 0}, {0, 5, 0}, {2.9, 0, 0}},
                    {{0, 3, 4}, {1, 3, 4}, {2, 3, 4}, {5, 3, 4}},
                    {}};
  weld(mesh, 1);
  EXPECT_THAT(mesh.vertices, ElementsAre(Vector3d(0, 0, 0), Vector3d(5, 0, 0), Vector3d(0, 5, 0),
                                         Vector3d(2.9, 0, 0)));
}

TEST(Weld, WorksAtAnyTolerance) {
  for (const double tolerance : {1e-300, 1e-30, 1e-15}) {
    TriangleMesh mesh = exploded(cube({1e5, 0, 0}, 1), 0);
    weld(mesh, tolerance);
    EXPECT_EQ(mesh.vertices.size(), 8U);
  }
  TriangleMesh mesh = cube({0, 0, 0}, 1);
  weld(mesh, 1e300);
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(Weld, KeepsTheColorsOfWhatIsLeft) {
  TriangleMesh mesh{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    {{1, 2, 3}},
                    {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
  weld(mesh, 0);
  EXPECT_EQ(mesh.vertices.size(), 3U) << "the one of no triangle goes";
  EXPECT_THAT(mesh.colors[2], ElementsAre(0, 0, 1));
}

}  // namespace
}  // namespace twrench::mesh
