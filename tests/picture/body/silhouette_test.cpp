#include "picture/body/silhouette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <tuple>

#include "picture/body/body_model.h"
#include "picture/body/gap_closing.h"
#include "picture/body/meshes.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Returns the silhouette of parts that do not intersect.
Silhouette silhouette_of(const Mesh& mesh) {
  return {mesh, PartIntersections(mesh.part_ends.size())};
}

/// Returns the silhouette of parts that may intersect.
Silhouette silhouette_of(const std::vector<body::Part>& parts) {
  const Mesh mesh = body_mesh(parts, 0);
  return {mesh, find_intersections(mesh, part_models(parts, mesh, 3))};
}

const glm::vec3 viewpoints[]{{0, 0, 20}, {3, -5, 17}, {-20, 1, 0.5F}, {9, 11, -13}, {0.1F, 30, 0}};

std::vector<std::pair<const char*, Mesh>> meshes() {
  return {{"cylinder", part_mesh(cylinder(1, 8, {0, 0, 0}, Vector3d(1, 1, 0)), 0.01)},
          {"box", part_mesh({body::Box{{2, 3, 4}}, 1, {0, 0, 0}, Matrix3d::Identity()}, 0.01)},
          {"ellipsoid",
           part_mesh({body::Ellipsoid{{1, 2, 3}}, 1, {0, 0, 0}, Matrix3d::Identity()}, 0.01)},
          {"wrench", body_mesh(close_gaps(t_wrench().body.parts), 0.01)}};
}

// An edge of the silhouette of a closed mesh lies between a front-facing and a back-facing
// triangle. The silhouette therefore has no ends.
TEST(Silhouette, IsClosedLoops) {
  for (const auto& [name, mesh] : meshes()) {
    Silhouette outline = silhouette_of(mesh);
    for (const glm::vec3& eye : viewpoints) {
      outline.find(eye, 30);
      ASSERT_GT(outline.edge_quads().size(), 12u) << name;
      ASSERT_EQ(6 * outline.edge_quads().size(), 4 * outline.indices().size()) << name;
      std::map<std::tuple<float, float, float>, int> ends;
      for (const EdgeQuadVertex& corner : outline.edge_quads()) {
        ++ends[{corner.position.x, corner.position.y, corner.position.z}];
      }
      for (const auto& [place, count] : ends) EXPECT_EQ(count % 4, 0) << name;
    }
  }
}

TEST(Silhouette, OfASphereIsTheCircleOfTangents) {
  constexpr float radius = 2;
  const body::Part sphere{
      body::Ellipsoid{{radius, radius, radius}}, 1, {0, 0, 0}, Matrix3d::Identity()};
  Silhouette outline = silhouette_of(part_mesh(sphere, 0.001));
  for (const glm::vec3& eye : viewpoints) {
    outline.find(eye, 30);
    const float distance = glm::length(eye);
    for (const EdgeQuadVertex& corner : outline.edge_quads()) {
      // At most half the size of a facet off the circle.
      EXPECT_NEAR(glm::dot(corner.position, eye) / distance, radius * radius / distance, 0.13F);
      EXPECT_NEAR(glm::dot(corner.normal, corner.position), radius, 1e-4F);
    }
  }
}

TEST(Silhouette, MovesItsVerticesAndLessThoseNearIt) {
  for (const auto& [name, mesh] : meshes()) {
    Silhouette outline = silhouette_of(mesh);
    for (const glm::vec3& eye : viewpoints) {
      outline.find(eye, 30);
      ASSERT_EQ(outline.shifts().size(), mesh.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const bool is_on_it =
            std::ranges::any_of(outline.edge_quads(),
                                [&, &at = mesh.vertices[i].position](const EdgeQuadVertex& corner) {
                                  return corner.position == at;
                                });
        if (is_on_it) {
          ASSERT_EQ(outline.shifts()[i].offset, -1) << name << ' ' << i;
        } else {
          ASSERT_GE(outline.shifts()[i].offset, -1) << name << ' ' << i;
          ASSERT_LE(outline.shifts()[i].offset, 0) << name << ' ' << i;
        }
      }
    }
  }
}

TEST(Silhouette, MovesNoOthersWherePixelsAreSmall) {
  Silhouette outline = silhouette_of(part_mesh(cylinder(2, 8, {0, 0, 0}, Vector3d(0, 1, 0)), 0.01));
  outline.find(viewpoints[0], 1e6F);
  const auto moved =
      std::ranges::count_if(outline.shifts(), [](const Shift& s) { return s.offset != 0; });
  const auto on_it = std::ranges::count(outline.shifts(), -1, &Shift::offset);
  EXPECT_GT(moved, 0);
  EXPECT_EQ(moved, on_it);
}

TEST(Silhouette, FinsHaveAnInnerAndAnOuterSide) {
  Silhouette outline = silhouette_of(meshes().front().second);
  outline.find(viewpoints[0], 30);
  for (std::size_t i = 0; i < outline.indices().size(); i += 6) {
    float sum = 0;
    for (std::size_t k = i; k < i + 6; ++k)
      sum += outline.edge_quads()[outline.indices()[k]].shift.offset;
    EXPECT_EQ(sum, 0);
  }
}

Mesh mesh_of_triangles(body::TriangleMesh triangles, double shell = 0) {
  return part_mesh(part_of(std::move(triangles), shell), 0);
}

// If the normals do not determine the outline, its edges do. Seen head-on, the corners of a box are
// moved along both edges.
TEST(Silhouette, OfABoxOfTrianglesIsMovedByAsMuchAtItsCorners) {
  Silhouette outline = silhouette_of(mesh_of_triangles(box_of_triangles({2, 2, 0.5})));
  outline.find({0, 0, 100}, 30);
  EXPECT_EQ(outline.indices().size(), 6U * 4);
  for (const EdgeQuadVertex& corner : outline.edge_quads()) {
    EXPECT_EQ(corner.normal, glm::vec3(0, 0, 1)) << "that of the face which one sees";
    EXPECT_NEAR(corner.shift.direction.x, corner.position.x, 0.01F);
    EXPECT_NEAR(corner.shift.direction.y, corner.position.y, 0.01F);
  }
}

/// An open box: a bottom and four hollow walls, made by cutting another box out of a box.
body::TriangleMesh bowl() {
  body::TriangleMesh mesh = box_of_triangles({4, 4, 2});
  const body::TriangleMesh hollow = box_of_triangles({3, 3, 2});
  // Both lids are removed. A rim joins their corners, which are 4 to 7 of each box.
  std::erase_if(mesh.triangles, [](const auto& t) { return t[0] >= 4 && t[1] >= 4 && t[2] >= 4; });
  for (const auto& v : hollow.vertices)
    mesh.vertices.emplace_back(v.x(), v.y(), v.z() > 0 ? 1 : -0.5);
  for (const auto& [a, b, c] : hollow.triangles) {
    if (a < 4 || b < 4 || c < 4) mesh.triangles.push_back({a + 8, c + 8, b + 8});
  }
  for (const auto& [a, b] : {std::pair(4U, 5U), {5U, 7U}, {7U, 6U}, {6U, 4U}}) {
    mesh.triangles.push_back({a, b, b + 8});
    mesh.triangles.push_back({a, b + 8, a + 8});
  }
  return mesh;
}

TEST(Silhouette, LeavesOutEdgesInHollows) {
  Silhouette outline = silhouette_of(mesh_of_triangles(bowl()));
  const glm::vec3 eye(9, 0.1F, 9);
  outline.find(eye, 30);
  int inside = 0;
  for (const EdgeQuadVertex& corner : outline.edge_quads()) {
    EXPECT_GT(corner.position.z, -1.01F);
    if (corner.lift == 0 && corner.position.z == -0.5F) ++inside;
  }
  EXPECT_EQ(inside, 0) << "the corners where the walls' insides meet the bottom";
  EXPECT_GT(outline.indices().size(), 0U);
}

/// The way by which a vertex is moved, in half pixels.
glm::vec3 way(const Shift& shift) {
  const float length = std::max(glm::length(shift.direction), 1e-9F);
  return shift.offset * std::max(length, 1.0F) / length * shift.direction;
}

// Three faces of a box are visible. Along each edge between two of them, each fades out over the
// other by half a pixel. The edges end on the outline, where the faces are shrunk, and so begin
// where these are moved to.
TEST(Silhouette, HasTwoQuadsForEachCreaseThatIsSeen) {
  const Mesh mesh = mesh_of_triangles(box_of_triangles({2, 2, 2}));
  Silhouette outline = silhouette_of(mesh);
  outline.find({9, 8, 7}, 30);
  EXPECT_EQ(outline.indices().size(), 6U * (6 + 2 * 3));
  int moved = 0;
  for (std::size_t i = 0; i < outline.edge_quads().size(); i += 2) {
    const EdgeQuadVertex &inner = outline.edge_quads()[i], &outer = outline.edge_quads()[i + 1];
    if (inner.lift != 1) continue;
    EXPECT_EQ(inner.transparency, 0.5F);
    EXPECT_EQ(outer.transparency, 1.0F);
    EXPECT_NEAR(glm::distance(way(inner.shift), way(outer.shift)), 1, 1e-5F);
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
      if (mesh.vertices[k].position != inner.position) continue;
      EXPECT_LT(glm::distance(way(inner.shift), way(outline.shifts()[k])), 1e-5F);
      moved += outline.shifts()[k].offset == 0 ? 0 : 1;
    }
  }
  EXPECT_GT(moved, 0);
}

// Another part may begin right behind the outline.
TEST(Silhouette, IsALittleNearerToTheEyeThanTheBody) {
  Silhouette outline = silhouette_of(mesh_of_triangles(ball_of_triangles(1, 20)));
  outline.find({3, 40, 5}, 30);
  for (const EdgeQuadVertex& corner : outline.edge_quads()) {
    EXPECT_GT(corner.lift, 0.05F);
    EXPECT_LT(corner.lift, 0.2F) << "it would cover parts in front of it";
  }
}

// A column through a cube. From above, the eye sees two of the four edges where it enters.
TEST(Silhouette, HasQuadsOnBothPartsAlongTheirIntersection) {
  const std::vector<body::Part> parts{part_of(box_of_triangles({2, 2, 2})),
                                      part_of(box_of_triangles({1, 1, 4}))};
  Silhouette outline = silhouette_of(parts);
  const auto seen_from = [&](const glm::vec3& eye) {
    outline.find(eye, 30);
    std::array<int, 2> corners{};  // of quads on the cube and on the column
    for (const EdgeQuadVertex& corner : outline.edge_quads()) {
      if (corner.lift <= 1) continue;
      EXPECT_NEAR(std::abs(corner.position.z), 1, 1e-4F);
      const float pixels = 0.5F * corner.shift.offset * glm::length(corner.shift.direction);
      const bool is_on_column = corner.normal.z == 0;
      EXPECT_EQ(corner.transparency, is_on_column && pixels > 0 ? 1 : 0);
      EXPECT_NEAR(std::abs(pixels), pixels < -0.55F ? 0.65F : 0.5F, 1e-5F);
      ++corners.at(is_on_column ? 1 : 0);
    }
    return corners;
  };
  const auto [on_cube, on_column] = seen_from({20, 15, 20});
  EXPECT_GE(on_cube, 2 * 4);
  EXPECT_EQ(on_column, 2 * on_cube) << "it fades out over the cube";
  EXPECT_EQ(seen_from({20, 15, 0}), (std::array{0, 0})) << "the cube's ends face away";
}

// A ball in a box, with so few facets that they lie far inside the ball. The quads show the normals
// of the points of the ball that the eye sees through its facets, as far as the ball is round.
TEST(Silhouette, ShowsTheRoundSurfaceWhereItEntersAnotherPart) {
  const std::vector<body::Part> parts{part_of(ball_of_triangles(1, 8)),
                                      part_of(box_of_triangles({4, 4, 0.6}))};
  Silhouette outline = silhouette_of(parts);
  const glm::vec3 eye(3, 5, 20);
  outline.find(eye, 30);
  float deepest = 0;
  for (const EdgeQuadVertex& corner : outline.edge_quads()) {
    if (corner.lift <= 1 || corner.normal == glm::vec3(0, 0, 1)) continue;
    const glm::vec3 towards_eye = corner.normal - corner.position;
    deepest = std::max(deepest, glm::length(towards_eye));
    EXPECT_NEAR(glm::length(corner.normal), 1, 1e-5F);
    EXPECT_LT(glm::length(glm::cross(towards_eye, glm::normalize(eye - corner.position))), 0.006F);
  }
  EXPECT_GT(deepest, 0.03F);
}

// The column's sides end less than half a pixel above the cube.
TEST(Silhouette, HasQuadsNoWiderThanTheTrianglesAtAnIntersection) {
  const std::vector<body::Part> parts{part_of(box_of_triangles({2, 2, 2})),
                                      part_of(box_of_triangles({1, 1, 2.03}))};
  Silhouette outline = silhouette_of(parts);
  outline.find({20, 15, 20}, 30);
  int corners = 0;
  for (const EdgeQuadVertex& corner : outline.edge_quads()) {
    if (corner.lift <= 1 || corner.normal.z != 0) continue;
    EXPECT_NEAR(std::abs(corner.shift.offset), 0.5F, 1e-5F);
    ++corners;
  }
  EXPECT_GT(corners, 0);
}

// On a circle of r pixels, the cosine a quarter of a pixel inside is sqrt(0.5 / r).
TEST(Silhouette, OfAMeshShowsWhatIsAQuarterOfAPixelInside) {
  Silhouette outline = silhouette_of(mesh_of_triangles(ball_of_triangles(1, 60)));
  const glm::vec3 eye(3, 40, 5);
  const auto facing = [&](float pixels) {
    outline.find(eye, pixels);
    std::vector<float> cosines;
    for (const EdgeQuadVertex& corner : outline.edge_quads()) {
      cosines.push_back(glm::dot(corner.normal, glm::normalize(eye - corner.position)));
    }
    std::ranges::nth_element(cosines, cosines.begin() + std::ssize(cosines) / 2);
    return cosines[cosines.size() / 2];
  };
  for (const float pixels : {100.0F, 25.0F, 4.0F}) {
    EXPECT_NEAR(facing(pixels), std::sqrt(0.5F / pixels), 0.02F) << pixels;
  }
}

/// A square bar along y with one rounded edge.
body::TriangleMesh bar_with_round_edge(double radius) {
  std::vector<Vector3d> section{{-1, 0, -1}, {1, 0, -1}};
  constexpr int strips = 6;
  for (int i = 0; i <= strips; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / strips;
    section.emplace_back(1 + radius * (std::cos(angle) - 1), 0, 1 + radius * (std::sin(angle) - 1));
  }
  section.emplace_back(-1, 0, 1);
  body::TriangleMesh bar;
  const auto count = static_cast<std::uint32_t>(section.size());
  for (const double end : {-1, 1}) {
    for (const Vector3d& place : section) bar.vertices.emplace_back(place.x(), end, place.z());
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    bar.triangles.insert(bar.triangles.end(),
                         {{i, count + i, next}, {next, count + i, count + next}});
    if (i == 0 || next == 0) continue;
    bar.triangles.insert(bar.triangles.end(), {{0, i, next}, {count, count + next, count + i}});
  }
  return bar;
}

// The rounded edge is a tenth of a pixel wide. The face beyond it is seen from above.
TEST(Silhouette, ShowsTheFaceBeyondARoundedEdgeThatIsTooNarrow) {
  Silhouette outline = silhouette_of(mesh_of_triangles(bar_with_round_edge(0.01)));
  outline.find({0, 0, 20}, 10);
  int corners = 0;
  for (const EdgeQuadVertex& corner : outline.edge_quads()) {
    if (corner.position.x < 0.9F || std::abs(corner.shift.direction.y) > 0.9F) continue;
    EXPECT_GT(corner.normal.z, 0.99F);
    ++corners;
  }
  EXPECT_GE(corners, 4);
}

TEST(Silhouette, OfAWallIsItsBorder) {
  Silhouette outline =
      silhouette_of(mesh_of_triangles({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}}, 0.1));
  for (const float side : {1.0F, -1.0F}) {
    outline.find({0, 0, side * 20}, 30);
    EXPECT_EQ(outline.indices().size(), 6U * 3);
    for (const EdgeQuadVertex& corner : outline.edge_quads()) EXPECT_EQ(corner.normal.z, side);
  }
}

}  // namespace
}  // namespace twrench::picture
