#include "picture/body/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <ostream>
#include <string>

namespace twrench::picture {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

Vector3d vector(const glm::vec3& v) { return {v.x, v.y, v.z}; }

struct Case {
  std::string name;
  body::Shape shape;
  double volume;  ///< of the shape as drawn, including bevels
  double area;
};

void PrintTo(const Case& value, std::ostream* out) { *out << value.name; }

constexpr double mesh_tolerance = 5e-4;
// For all cases, because their smallest half dimension is 1.
constexpr double rim_bevel = 0.04;
constexpr double edge_bevel = 0.08;  // of boxes

/// Pappus: a bevel removes from a sharp rim a ring whose section is a square minus a quarter disc.
Case rounded_cylinder() {
  const double radius = 1;
  const double length = 8;
  const double square = rim_bevel * rim_bevel;
  const double disc = pi * square / 4;
  const double inner = radius - rim_bevel;
  const double lost =
      2 * pi * (square * (inner + rim_bevel / 2) - disc * inner - square * rim_bevel / 3);
  const double arc = pi / 2 * rim_bevel;
  const double cap = pi * inner * inner;
  const double rim = 2 * pi * arc * (inner + 2 / pi * rim_bevel);
  const double side = 2 * pi * radius * (length - 2 * rim_bevel);
  return {"cylinder", body::Cylinder{radius, length}, pi * radius * radius * length - 2 * lost,
          2 * (cap + rim) + side};
}

/// Steiner: a box grown by the bevel on all sides.
Case rounded_box() {
  const Vector3d size(2, 3, 4);
  const Vector3d inner = size.array() - 2 * edge_bevel;
  const double faces = 2 * (inner.x() * inner.y() + inner.y() * inner.z() + inner.z() * inner.x());
  const double edges = 4 * inner.sum();
  return {"box", body::Box{size},
          inner.prod() + edge_bevel * faces + pi / 4 * edge_bevel * edge_bevel * edges +
              4 * pi / 3 * edge_bevel * edge_bevel * edge_bevel,
          faces + pi / 2 * edge_bevel * edges + 4 * pi * edge_bevel * edge_bevel};
}

Case prolate_ellipsoid() {
  const double a = 1;
  const double c = 3;
  const double e = std::sqrt(1 - a * a / (c * c));
  return {"ellipsoid", body::Ellipsoid{{a, a, c}}, 4 * pi / 3 * a * a * c,
          2 * pi * a * a * (1 + c / (a * e) * std::asin(e))};
}

class PartMesh : public testing::TestWithParam<Case> {
 protected:
  body::Part part{GetParam().shape,
                  1.0,
                  {0.5, -2, 1},
                  Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix()};
  Mesh mesh = part_mesh(part, mesh_tolerance);

  std::array<Vector3d, 3> corners(std::size_t triangle) const {
    const auto corner = [&](std::size_t k) {
      return vector(mesh.vertices[mesh.indices[3 * triangle + k]].position);
    };
    return {corner(0), corner(1), corner(2)};
  }
  std::size_t triangle_count() const { return mesh.indices.size() / 3; }
};

TEST_P(PartMesh, IsClosedAndConsistentlyTurned) {
  const auto key = [&](std::uint32_t i) {
    const glm::vec3 p = mesh.vertices[i].position;
    return std::array{p.x, p.y, p.z};
  };
  using Corner = std::array<float, 3>;
  std::map<std::pair<Corner, Corner>, int> edges;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{key(mesh.indices[i + k]), key(mesh.indices[i + (k + 1) % 3])}];
    }
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1U) << "an edge with one triangle";
  }
}

TEST_P(PartMesh, EnclosesTheVolumeAndHasTheAreaOfTheShape) {
  double volume = 0;
  double area = 0;
  for (std::size_t i = 0; i < triangle_count(); ++i) {
    const auto [a, b, c] = corners(i);
    volume += a.dot(b.cross(c)) / 6;  // divergence theorem; positive if the winding is outward
    area += (b - a).cross(c - a).norm() / 2;
  }
  EXPECT_NEAR(volume / GetParam().volume, 1, 1e-3);
  EXPECT_NEAR(area / GetParam().area, 1, 1e-3);
}

TEST_P(PartMesh, HasUnitNormalsAlongItsTriangles) {
  for (const Vertex& vertex : mesh.vertices) ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-6);
  for (std::size_t i = 0; i < triangle_count(); ++i) {
    const auto [a, b, c] = corners(i);
    const Vector3d facet = (b - a).cross(c - a).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d normal = vector(mesh.vertices[mesh.indices[3 * i + k]].normal);
      // At most half a facet of the bevel, which is the coarsest: a fifth of a quarter turn. On the
      // spheres at a box's corners, half the diagonal of a facet.
      ASSERT_GT(normal.dot(facet), std::cos(0.223)) << "triangle " << i;
    }
  }
}

TEST_P(PartMesh, StaysInsideTheShapesBoundingSphere) {
  double farthest = 0;
  for (const Vertex& vertex : mesh.vertices) {
    farthest = std::max(farthest, (vector(vertex.position) - part.position).norm());
  }
  EXPECT_LE(farthest, body::bounding_radius(part.shape) + 1e-5);
  EXPECT_GE(farthest, body::bounding_radius(part.shape) - edge_bevel);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PartMesh,
                         testing::Values(rounded_cylinder(), rounded_box(), prolate_ellipsoid()),
                         [](const auto& param) { return param.param.name; });

TEST(CylinderMesh, HasItsSideAndItsCapsOnTheExactCylinder) {
  const body::Part part{body::Cylinder{2, 10}, 1.0, Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  for (const Vertex& vertex : part_mesh(part, mesh_tolerance).vertices) {
    const Vector3d p = vector(vertex.position);
    const double across = std::hypot(p.x(), p.y());
    ASSERT_LE(across, 2 + 1e-6);
    ASSERT_LE(std::abs(p.z()), 5 + 1e-6);
    if (std::abs(vertex.normal.z) < 1e-3F) {
      ASSERT_NEAR(across, 2, 1e-6);
    }
    if (std::abs(vertex.normal.z) > 0.9999F) {
      ASSERT_NEAR(std::abs(p.z()), 5, 1e-6);
    }
  }
}

TEST(EllipsoidMesh, HasEveryVertexOnTheSurfaceWithItsGradientAsNormal) {
  const Vector3d radii(1, 2, 3);
  const body::Part part{body::Ellipsoid{radii}, 1.0, Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  for (const Vertex& vertex : part_mesh(part, mesh_tolerance).vertices) {
    const Vector3d p = vector(vertex.position);
    ASSERT_NEAR(p.cwiseQuotient(radii).norm(), 1, 1e-6);
    const Vector3d gradient = p.cwiseQuotient(radii.cwiseProduct(radii)).normalized();
    ASSERT_GT(gradient.dot(vector(vertex.normal)), 1 - 1e-6);
  }
}

TEST(PartMeshTolerance, BoundsHowFarTheFacetsLieInside) {
  const body::Part ball{body::Ellipsoid{{2, 2, 2}}, 1.0, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  std::size_t count = 0;
  for (const double bound : {0.02, 0.005, 0.001}) {
    const Mesh mesh = part_mesh(ball, bound);
    EXPECT_GT(mesh.vertices.size(), count) << "finer, the smaller the mesh_tolerance";
    count = mesh.vertices.size();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = mesh.vertices[mesh.indices[i + k]].position;
        const auto& b = mesh.vertices[mesh.indices[i + (k + 1) % 3]].position;
        // The diagonals of a facet deviate by twice the bound.
        ASSERT_GT(vector(0.5F * (a + b)).norm(), 2 - 2.1 * bound);
      }
    }
  }
}

TEST(BodyMesh, JoinsTheMeshesOfItsParts) {
  const body::Part ball{body::Ellipsoid{{1, 1, 1}}, 1.0, {5, 0, 0}, Eigen::Matrix3d::Identity()};
  const body::Part box{body::Box{{1, 1, 1}}, 1.0, {-5, 0, 0}, Eigen::Matrix3d::Identity()};
  const std::array parts{ball, box};
  const Mesh mesh = body_mesh(parts, mesh_tolerance);
  EXPECT_EQ(mesh.vertices.size(), part_mesh(ball, mesh_tolerance).vertices.size() +
                                      part_mesh(box, mesh_tolerance).vertices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto side = [&](std::size_t k) {
      return mesh.vertices[mesh.indices[i + k]].position.x > 0;
    };
    ASSERT_TRUE(side(0) == side(1) && side(1) == side(2)) << "a triangle between two parts";
  }
}

}  // namespace
}  // namespace twrench::picture
