#include "picture/body/half_turn.h"

#include <gtest/gtest.h>
#include <twrench/body/mass_properties.h>
#include <twrench/math/so3.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "picture/body/meshes.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Parts = std::vector<body::Part>;

const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();

body::Part placed(const body::Shape& shape, const Vector3d& position = Vector3d::Zero(),
                  const Matrix3d& body_from_part = Matrix3d::Identity()) {
  return {shape, 1, position, body_from_part};
}

body::Part bar(const Vector3d& size, const Vector3d& position = Vector3d::Zero()) {
  return placed(body::Box{size}, position);
}

body::Part ball(const Vector3d& position) {
  return placed(body::Ellipsoid{{0.5, 0.5, 0.5}}, position);
}

std::vector<std::size_t> all_alike(const Parts& parts) { return std::vector(parts.size(), 0UL); }

bool is_same(const Parts& parts, const Vector3d& axis) {
  return looks_the_same_after_half_turn(parts, all_alike(parts), axis);
}

/// Whether the body looks the same turned over; the parts need not lie about the origin.
bool is_same_turned_over(Parts parts) {
  const body::MassProperties properties = body::mass_properties(parts);
  for (body::Part& part : parts) part.position -= properties.centre_of_mass;
  return looks_the_same_turned_over(parts, all_alike(parts),
                                    body::principal_axes(properties.inertia));
}

TEST(HalfTurn, MapsEachShapeToItselfAsItsFormSays) {
  const Matrix3d tilted = so3::exp(Vector3d(0.3, -0.5, 0.7));
  const std::vector<body::Shape> symmetric{body::Cylinder{1, 3},
                                           body::Box{{1, 2, 3}},
                                           body::Ellipsoid{{1, 2, 3}},
                                           body::Torus{3, 1},
                                           body::Capsule{1, 4},
                                           body::Tube{2, 1, 3},
                                           body::make_mesh(box_of_triangles({1, 2, 3}))};
  for (const body::Shape& shape : symmetric) {
    const Parts body{placed(shape, Vector3d::Zero(), tilted)};
    for (const Eigen::Index i : {0, 1, 2}) {
      EXPECT_TRUE(is_same(body, tilted.col(i))) << shape.index() << " about " << i;
    }
    EXPECT_FALSE(is_same(body, tilted * so3::exp(0.01 * z) * x) &&
                 is_same(body, tilted * so3::exp(0.01 * y) * x))
        << shape.index();
    EXPECT_FALSE(is_same({placed(shape, {0.1, 0, 0}, tilted)}, y)) << "beside the axis";
  }
  const Parts cone{placed(body::Cone{2, 3, 1}, Vector3d::Zero(), tilted)};
  EXPECT_TRUE(is_same(cone, tilted.col(2)));
  EXPECT_FALSE(is_same(cone, tilted.col(0)));
  EXPECT_FALSE(is_same(cone, tilted.col(1)));
}

TEST(HalfTurn, MapsAssembliesOfAnySize) {
  for (const double size : {1e-6, 1.0, 1e6}) {
    const auto scaled = [&](const Vector3d& v) { return Vector3d(size * v); };
    const Parts box{bar(scaled({1, 2, 3}))};
    EXPECT_TRUE(is_same_turned_over(box)) << size;
    const Parts with_axle{box[0], placed(body::Cylinder{0.3 * size, 5 * size})};
    EXPECT_TRUE(is_same_turned_over(with_axle)) << size;
    const Parts with_knob{box[0], placed(body::Cylinder{0.3 * size, size}, scaled({0, 0, 2}))};
    EXPECT_TRUE(is_same(with_knob, z)) << size;
    EXPECT_FALSE(is_same(with_knob, x)) << size;
    const Parts cross{bar(scaled({6, 1, 1})), bar(scaled({1, 4, 1}))};
    EXPECT_TRUE(is_same_turned_over(cross)) << size;
    const Parts off_centre{cross[0], bar(scaled({1, 4, 1}), scaled({1, 0.2, 0}))};
    EXPECT_FALSE(is_same_turned_over(off_centre)) << size;
    const Parts mesh{part_of(box_of_triangles(scaled({1, 2, 3})))};
    EXPECT_TRUE(is_same_turned_over(mesh)) << size;
    const Parts wrench{cylinder(size, 8 * size, scaled({-1, 0, 0}), y),
                       cylinder(size, 4 * size, scaled({2, 0, 0}), x)};
    EXPECT_TRUE(is_same(wrench, x)) << size;
    EXPECT_FALSE(is_same(wrench, y) || is_same(wrench, z)) << size;
    EXPECT_FALSE(is_same_turned_over(wrench)) << size;
  }
}

TEST(HalfTurn, ExchangesPartsThatLookAlike) {
  const Parts body{bar({1, 2, 3}, {2, 0, 0}), bar({1, 2, 3}, {-2, 0, 0})};
  const std::vector<std::size_t> alike{0, 0}, different{0, 1};
  for (const Vector3d& axis : {x, y, z}) {
    EXPECT_TRUE(looks_the_same_after_half_turn(body, alike, axis));
    EXPECT_EQ(looks_the_same_after_half_turn(body, different, axis), axis == x);
  }
  EXPECT_FALSE(is_same({bar({1, 2, 3}, {2, 0, 0}), bar({1, 2, 2.9}, {-2, 0, 0})}, z));
  EXPECT_FALSE(
      is_same({placed(body::Tube{2, 1, 1}, 2 * z), placed(body::Tube{2, 1.1, 1}, -2 * z)}, x))
      << "another bore";
  const Matrix3d eighth = so3::exp(std::numbers::pi / 4 * x);
  EXPECT_FALSE(
      is_same({bar({1, 2, 2}, {2, 0, 0}), placed(body::Box{{1, 2, 2}}, -2 * x, eighth)}, z))
      << "a square turned by 45 degrees has the same inertia";
}

TEST(HalfTurn, ComparesTheVerticesOfMeshesAndTheirColours) {
  body::TriangleMesh box = box_of_triangles({1, 2, 3});
  const auto with_corner = [&](double shift) {
    body::TriangleMesh mesh = box;
    mesh.vertices[7] *= 1 + shift;
    return Parts{part_of(mesh)};
  };
  EXPECT_TRUE(is_same(with_corner(1e-5), x)) << "the digits of a file";
  EXPECT_FALSE(is_same(with_corner(1e-2), x));
  box.colors.assign(8, {1, 0, 0});
  EXPECT_TRUE(is_same({part_of(box)}, x));
  box.colors[7] = {0, 0, 1};
  EXPECT_FALSE(is_same({part_of(box)}, x)) << "its own colours show how it turns";
}

/// A hexagonal plate of triangles, turned by an angle about its axis.
body::TriangleMesh hexagonal_plate(double angle, double narrowing) {
  body::TriangleMesh mesh;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 6; ++i) {
      const double at = angle + i * std::numbers::pi / 3, radius = 3 * (1 - narrowing * (1 + side));
      mesh.vertices.emplace_back(radius * std::cos(at), radius * std::sin(at), 0.2 * side);
    }
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, 6 + i});
    mesh.triangles.push_back({j, 6 + j, 6 + i});
    if (i > 0 && i < 5) {
      mesh.triangles.push_back({0, i + 1, i});
      mesh.triangles.push_back({6, 6 + i, 7 + i});
    }
  }
  return mesh;
}

TEST(HalfTurn, OfABodyWithEqualMomentsIsFoundAboutAnyAxis) {
  EXPECT_TRUE(is_same_turned_over({bar({2, 2, 3})}));
  EXPECT_TRUE(is_same_turned_over({bar({2, 2, 2})}));
  const double half = std::sqrt(3) / 2;
  const Parts triangle{ball({2, 0, 0}), ball({-1, 2 * half, 0}), ball({-1, -2 * half, 0})};
  EXPECT_TRUE(is_same_turned_over(triangle));
  Parts pyramid = triangle;
  pyramid.push_back(ball({0, 0, 1}));
  EXPECT_FALSE(is_same_turned_over(pyramid));
  EXPECT_TRUE(is_same_turned_over(
      {ball({1, 1, 1}), ball({1, -1, -1}), ball({-1, 1, -1}), ball({-1, -1, 1})}))
      << "a tetrahedron";
  EXPECT_TRUE(is_same_turned_over({part_of(hexagonal_plate(0.2, 0))}));
  EXPECT_FALSE(is_same_turned_over({part_of(hexagonal_plate(0.2, 0.1))}));
  EXPECT_TRUE(is_same_turned_over({part_of(ball_of_triangles(1, 40))}));
}

}  // namespace
}  // namespace twrench::picture
