#include "mesh/polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "sanitizers.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Ring = std::vector<Vector2d>;

/// Returns the triangles of a plane polygon that is placed obliquely in space.
body::TriangleMesh triangulated(const Ring& ring) {
  const Eigen::Matrix3d frame =
      Eigen::AngleAxisd(2.0, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  body::TriangleMesh mesh;
  for (const Vector2d& point : ring) {
    mesh.vertices.emplace_back(Vector3d(5, -3, 9) + frame * Vector3d(point.x(), point.y(), 0));
  }
  std::vector<std::uint32_t> corners(ring.size());
  std::iota(corners.begin(), corners.end(), 0U);
  Polygons polygons;
  polygons.add(corners, mesh);
  polygons.triangulate(mesh);
  return mesh;
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns twice the area, positive if the polygon is counter-clockwise.
double doubled_area(const Ring& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += cross(ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

/// Returns, for each edge of the border, how often triangles traverse it forwards minus how often
/// backwards.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> border(const body::TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  return edges;
}

/// Expects triangles with the polygon's orientation, total area and border. They then lie within it
/// and do not overlap.
void expect_tiled(const Ring& ring) {
  const body::TriangleMesh mesh = triangulated(ring);
  const double whole = doubled_area(ring);
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double area = cross(ring[b] - ring[a], ring[c] - ring[a]);
    EXPECT_GE(area * whole, -1e-12 * whole * whole);
    sum += std::abs(area);
  }
  EXPECT_NEAR(sum, std::abs(whole), 1e-9 * std::abs(whole));
  EXPECT_EQ(mesh.triangles.size(), ring.size() - 2);
  EXPECT_EQ(border(mesh).size(), ring.size());
}

void expect_tiled_however_it_begins(Ring ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    expect_tiled(ring);
    std::ranges::rotate(ring, ring.begin() + 1);
  }
  std::ranges::reverse(ring);
  expect_tiled(ring);
}

std::size_t without_area(const Ring& ring) {
  const auto triangles = triangulated(ring).triangles;
  return static_cast<std::size_t>(std::ranges::count_if(triangles, [&](const auto& t) {
    return std::abs(cross(ring[t[1]] - ring[t[0]], ring[t[2]] - ring[t[0]])) < 1e-12;
  }));
}

TEST(Polygon, ThatIsConvexIsAFan) {
  const auto triangles = triangulated({{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}).triangles;
  for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(triangles[k], (std::array{0U, k + 1, k + 2}));
}

TEST(Polygon, ThatIsConcaveIsFilledWithin) {
  expect_tiled_however_it_begins({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}});
  expect_tiled_however_it_begins({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}});
}

TEST(Polygon, OfManyCornersAtAnyDistanceFromItsMiddleIsFilledWithin) {
  std::uint32_t state = 1;
  for (int trial = 0; trial < 200; ++trial) {
    Ring ring;
    const int corners = 4 + trial % 40;
    for (int i = 0; i < corners; ++i) {
      state = state * 1664525U + 1013904223U;
      const double angle = 2 * std::numbers::pi * i / corners, radius = 0.1 + 1e-9 * (state >> 2U);
      ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    expect_tiled(ring);
  }
}

// A corner in the middle of a straight edge is a vertex of the surface and must be kept.
TEST(Polygon, WithCornersOnAStraightLineHasNoTriangleWithoutArea) {
  for (Ring ring : {Ring{{0, 0}, {1, 0}, {2, 0}, {2, 2}},
                    Ring{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {1, 2}, {0, 2}},
                    Ring{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}, {0, 0.5}}}) {
    expect_tiled_however_it_begins(ring);
    EXPECT_EQ(without_area(ring), 0);
  }
}

TEST(Polygon, WithAHoleJoinedToItsOutlineIsFilledWithin) {
  expect_tiled({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});
  expect_tiled({{2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}, {0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}});
}

TEST(Polygon, WithRepeatedCornersIsFilledWithin) {
  expect_tiled({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {4, 4}, {1, 1}, {0, 4}});
  expect_tiled({{0, 0}, {4, 0}, {4, 4}, {6, 6}, {4, 4}, {1, 3}, {0, 4}});
}

TEST(Polygon, ThatCrossesItselfOrHasNoAreaIsAFan) {
  for (const Ring& ring :
       {Ring{{0, 0}, {2, 2}, {2, 0}, {0, 3}}, Ring{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}) {
    const auto triangles = triangulated(ring).triangles;
    EXPECT_EQ(triangles[0], (std::array{0U, 1U, 2U}));
    EXPECT_EQ(triangles[1], (std::array{0U, 2U, 3U}));
  }
}

// The area of the bounding box underflows to 0 for the first size, and differences of coordinates
// overflow for the second.
TEST(Polygon, OfExtremeCoordinatesIsOfTrianglesOfItsCorners) {
  for (const double size : {1e-170, 1e308}) {
    body::TriangleMesh mesh;
    constexpr int corners = 30'000;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const double radius = i % 2 == 0 ? size : 0.1 * size;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    std::vector<std::uint32_t> ring(corners);
    std::iota(ring.begin(), ring.end(), 0U);
    Polygons polygons;
    polygons.add(ring, mesh);
    polygons.triangulate(mesh);
    EXPECT_EQ(mesh.triangles.size(), ring.size() - 2);
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) ASSERT_LT(corner, ring.size());
    }
  }
}

// A time-out indicates that each corner is compared with all others.
TEST(Polygon, OfVeryManyCornersIsFilledWithin) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for so many corners";
  constexpr int teeth = 15'000, corners = 100'000;
  Ring comb{{0, -1}, {2 * teeth, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    comb.emplace_back(2 * i + 1.3, 1000);
    comb.emplace_back(2 * i, 0);
  }
  expect_tiled(comb);
  Ring spiral;
  for (int i = 0; i < corners; ++i) {
    const bool is_outward = i < corners / 2;
    const double angle = 1 + 0.01 * (is_outward ? i : corners - 1 - i);
    spiral.push_back((angle + (is_outward ? 1 : -1)) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  expect_tiled(spiral);
  Ring star;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    star.push_back((i % 2 == 0 ? 1 : 0.01) * Vector2d(std::cos(angle), std::sin(angle)));
  }
  expect_tiled(star);
}

}  // namespace
}  // namespace twrench::mesh
