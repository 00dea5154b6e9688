#include "picture/body/facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>
#include <utility>

#include "picture/body/gap_closing.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr double facet_tolerance = 0.003;

const std::array<glm::vec3, 5> facet_viewpoints{
    {{0, 0, 20}, {3, -5, 17}, {-20, 1, 0.5F}, {9, 11, -13}, {0.1F, 30, 0}}};

Mesh wrench() { return body_mesh(close_gaps(t_wrench().body.parts), facet_tolerance); }

Mesh upright_cylinder() {
  return body_mesh(
      std::array{body::Part{body::Cylinder{1, 6}, 1, {0, 0, 0}, Eigen::Matrix3d::Identity()}},
      facet_tolerance);
}

bool faces(const Mesh& mesh, const std::uint32_t* corners, const glm::vec3& eye) {
  const glm::vec3 a = mesh.vertices[corners[0]].position;
  return glm::dot(glm::cross(mesh.vertices[corners[1]].position - a,
                             mesh.vertices[corners[2]].position - a),
                  eye - a) > 0;
}

Facets facets_seen_from(const Mesh& mesh, const glm::vec3& eye) {
  std::vector<char> seen;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    seen.push_back(faces(mesh, &mesh.indices[i], eye) ? 1 : 0);
  }
  return visible_facets(mesh, eye, seen);
}

/// Returns the directed edges of triangles that have no partner.
std::set<Edge> borders(const std::vector<std::uint32_t>& indices) {
  std::set<Edge> result;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge(indices[i + k], indices[i + (k + 1) % 3]);
      if (result.erase({edge.second, edge.first}) == 0) {
        EXPECT_TRUE(result.insert(edge).second) << "twice the same way";
      }
    }
  }
  return result;
}

TEST(Facets, HaveNoGapButWhereTheSideIsTurnedAway) {
  const Mesh mesh = wrench();
  for (const glm::vec3& eye : facet_viewpoints) {
    std::set<Edge> of_unseen;
    for (const auto& side : mesh.sides) {
      for (std::size_t i = side->begin; i < side->begin + std::size_t{6} * side->count; i += 3) {
        if (faces(mesh, &mesh.indices[i], eye)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          of_unseen.emplace(mesh.indices[i + k], mesh.indices[i + (k + 1) % 3]);
        }
      }
    }
    for (const auto& [from, to] : borders(facets_seen_from(mesh, eye).indices)) {
      EXPECT_TRUE(of_unseen.contains({to, from}));
    }
  }
}

TEST(Facets, AreFewerOnTheSideAndTheSameAtTheOutline) {
  const Mesh mesh = upright_cylinder();
  const CylinderSide& side = *mesh.sides[0];
  const glm::vec3 eye(3, -20, 5);
  const Facets facets = facets_seen_from(mesh, eye);
  EXPECT_TRUE(std::equal(mesh.indices.begin(),
                         mesh.indices.begin() + static_cast<std::ptrdiff_t>(side.begin),
                         facets.indices.begin()));
  const auto mesh_side = static_cast<std::ptrdiff_t>(side.begin);
  std::set<Edge> lengthwise;  // between a vertex of the lower ring and the one above it
  for (auto i = facets.indices.begin() + mesh_side; i != facets.indices.end(); i += 3) {
    for (const auto& [from, to] : {Edge(i[0], i[1]), {i[1], i[2]}, {i[2], i[0]}}) {
      const auto [low, high] = std::minmax(from, to);
      if (high == low + side.count) lengthwise.emplace(low, high);
    }
  }
  std::uint32_t seen = 0;
  for (std::uint32_t strip = 0; strip < side.count; ++strip) {
    const std::size_t at = side.begin + std::size_t{6} * strip;
    const bool is_seen = faces(mesh, &mesh.indices[at], eye);
    const std::size_t next = side.begin + std::size_t{6} * ((strip + 1) % side.count);
    if (is_seen != faces(mesh, &mesh.indices[next], eye)) {
      const std::uint32_t end = side.low + (strip + 1) % side.count;
      EXPECT_TRUE(lengthwise.contains({end, end + side.count})) << "the outline";
    }
    if (is_seen) ++seen;
  }
  ASSERT_GT(seen, 16U);
  EXPECT_LT(lengthwise.size(), seen / 2 + 4);
}

TEST(Facets, TellHowDeepTheyLie) {
  const Mesh mesh = upright_cylinder();
  const double half_angle = 4 * std::numbers::pi / mesh.sides[0]->count;
  EXPECT_NEAR(facets_seen_from(mesh, {0, 20, 0}).depth, 1 - std::cos(half_angle), 1e-6);
}

TEST(Facets, HaveNoSideForAnEyeAtTheEnd) {
  const Mesh mesh = upright_cylinder();
  const Facets facets = facets_seen_from(mesh, {0.5F, 0, 20});
  EXPECT_EQ(facets.indices.size(), mesh.sides[0]->begin);
  EXPECT_EQ(facets.depth, 0);
}

TEST(Facets, OfOtherShapesAreTheMeshs) {
  const Mesh mesh = body_mesh(
      std::array{body::Part{body::Box{{2, 3, 4}}, 1, {0, 0, 0}, Eigen::Matrix3d::Identity()},
                 body::Part{body::Ellipsoid{{1, 2, 3}}, 1, {4, 0, 0}, Eigen::Matrix3d::Identity()}},
      facet_tolerance);
  const Facets facets = facets_seen_from(mesh, facet_viewpoints[1]);
  EXPECT_EQ(facets.indices, mesh.indices);
  EXPECT_EQ(facets.part_ends, mesh.part_ends);
}

}  // namespace
}  // namespace twrench::picture
