#include "render/body/silhouette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "render/body/gap_closing.h"
#include "render/t_wrench.h"

namespace twrench::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const glm::vec3 viewpoints[]{{0, 0, 20}, {3, -5, 17}, {-20, 1, 0.5F}, {9, 11, -13}, {0.1F, 30, 0}};

std::vector<std::pair<const char*, Mesh>> meshes() {
  return {{"cylinder", part_mesh(cylinder(1, 8, {0, 0, 0}, Vector3d(1, 1, 0)), 0.01)},
          {"box", part_mesh({body::Box{{2, 3, 4}}, 1, {0, 0, 0}, Matrix3d::Identity()}, 0.01)},
          {"ellipsoid",
           part_mesh({body::Ellipsoid{{1, 2, 3}}, 1, {0, 0, 0}, Matrix3d::Identity()}, 0.01)},
          {"wrench", body_mesh(close_gaps(t_wrench().body.parts), 0.01)}};
}

// An edge of a closed mesh lies between a front-facing and a back-facing triangle, or it is not on
// the silhouette: so the silhouette has no ends.
TEST(Silhouette, IsClosedLoops) {
  for (const auto& [name, mesh] : meshes()) {
    Silhouette outline(mesh);
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
  Silhouette outline(part_mesh(sphere, 0.001));
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
    Silhouette outline(mesh);
    for (const glm::vec3& eye : viewpoints) {
      outline.find(eye, 30);
      ASSERT_EQ(outline.offsets().size(), mesh.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const bool is_on_it =
            std::ranges::any_of(outline.edge_quads(),
                                [&, &at = mesh.vertices[i].position](const EdgeQuadVertex& corner) {
                                  return corner.position == at;
                                });
        if (is_on_it) {
          ASSERT_EQ(outline.offsets()[i], -1) << name << ' ' << i;
        } else {
          ASSERT_GE(outline.offsets()[i], -1) << name << ' ' << i;
          ASSERT_LE(outline.offsets()[i], 0) << name << ' ' << i;
        }
      }
    }
  }
}

TEST(Silhouette, MovesNoOthersWherePixelsAreSmall) {
  Silhouette outline(part_mesh(cylinder(2, 8, {0, 0, 0}, Vector3d(0, 1, 0)), 0.01));
  outline.find(viewpoints[0], 1e6F);
  const auto moved = std::ranges::count_if(outline.offsets(), [](float o) { return o != 0; });
  const auto on_it = std::ranges::count(outline.offsets(), -1);
  EXPECT_GT(moved, 0);
  EXPECT_EQ(moved, on_it);
}

TEST(Silhouette, FinsHaveAnInnerAndAnOuterSide) {
  Silhouette outline(meshes().front().second);
  outline.find(viewpoints[0], 30);
  for (std::size_t i = 0; i < outline.indices().size(); i += 6) {
    float sum = 0;
    for (std::size_t k = i; k < i + 6; ++k)
      sum += outline.edge_quads()[outline.indices()[k]].offset;
    EXPECT_EQ(sum, 0);
  }
}

}  // namespace
}  // namespace twrench::render
