#include "render/outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "render/joined_parts.h"
#include "t_wrench.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const glm::vec3 eyes[]{{0, 0, 20}, {3, -5, 17}, {-20, 1, 0.5F}, {9, 11, -13}, {0.1F, 30, 0}};

std::vector<std::pair<const char*, Mesh>> meshes() {
  return {
      {"cylinder", part_mesh(cylinder(1, 8, {0, 0, 0}, Vector3d(1, 1, 0)), 0.01)},
      {"box", part_mesh({Box{{2, 3, 4}}, 1, {0, 0, 0}, Matrix3d::Identity()}, 0.01)},
      {"ellipsoid", part_mesh({Ellipsoid{{1, 2, 3}}, 1, {0, 0, 0}, Matrix3d::Identity()}, 0.01)},
      {"wrench", body_mesh(joined_parts(t_wrench().body.parts), 0.01)}};
}

// An edge of a closed mesh is between one seen triangle and one that is not, or it is not of the
// outline: so the outline has no ends.
TEST(Outline, IsClosedLoops) {
  for (const auto& [name, mesh] : meshes()) {
    Outline outline(mesh);
    for (const glm::vec3& eye : eyes) {
      outline.find(eye);
      ASSERT_GT(outline.fins().size(), 12u) << name;
      ASSERT_EQ(6 * outline.fins().size(), 4 * outline.indices().size()) << name;
      std::map<std::tuple<float, float, float>, int> ends;
      for (const FinVertex& corner : outline.fins()) {
        ++ends[{corner.position.x, corner.position.y, corner.position.z}];
      }
      for (const auto& [place, count] : ends) EXPECT_EQ(count % 4, 0) << name;
    }
  }
}

TEST(Outline, OfASphereIsTheCircleOfTangents) {
  constexpr float radius = 2;
  const Part sphere{Ellipsoid{{radius, radius, radius}}, 1, {0, 0, 0}, Matrix3d::Identity()};
  Outline outline(part_mesh(sphere, 0.001));
  for (const glm::vec3& eye : eyes) {
    outline.find(eye);
    const float distance = glm::length(eye);
    for (const FinVertex& corner : outline.fins()) {
      // A facet's half size off the circle, at most.
      EXPECT_NEAR(glm::dot(corner.position, eye) / distance, radius * radius / distance, 0.13F);
      EXPECT_NEAR(glm::dot(corner.normal, corner.position), radius, 1e-4F);
    }
  }
}

TEST(Outline, MovesItsVerticesAndNoOthers) {
  for (const auto& [name, mesh] : meshes()) {
    Outline outline(mesh);
    for (const glm::vec3& eye : eyes) {
      outline.find(eye);
      ASSERT_EQ(outline.offsets().size(), mesh.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const bool is_on_it = std::ranges::any_of(outline.fins(), [&](const FinVertex& corner) {
          return corner.position == mesh.vertices[i].position;
        });
        ASSERT_EQ(outline.offsets()[i], is_on_it ? -1 : 0) << name << ' ' << i;
      }
    }
  }
}

TEST(Outline, FinsHaveAnInnerAndAnOuterSide) {
  Outline outline(meshes().front().second);
  outline.find(eyes[0]);
  for (std::size_t i = 0; i < outline.indices().size(); i += 6) {
    float sum = 0;
    for (std::size_t k = i; k < i + 6; ++k) sum += outline.fins()[outline.indices()[k]].offset;
    EXPECT_EQ(sum, 0);
  }
}

}  // namespace
}  // namespace twrench
