#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/body/triangle_mesh.h>
#include <twrench/math/so3.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "body/sample_meshes.h"

namespace twrench::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;
using testing::HasSubstr;

/// Results of exact arithmetic, rounded to double.
struct Exact {
  const char* name;
  std::size_t triangles;
  /// Volume, centroid, and the inertia's xx, yy, zz, yz, xz, xy about it.
  std::array<double, 10> values;
};

constexpr std::array exact_integrals{std::to_array<Exact>({
#include "body/mesh_reference.inc"
})};

TriangleMesh sample(std::string name) {
  if (const std::size_t at = name.find(", far away"); at != std::string::npos) {
    return moved(sample(name.substr(0, at)), {1e4, -2e4, 3e4});
  }
  if (name == "lumps") return lumpy_cube(92);
  if (name == "hollow") return hollow(lumpy_cube(16), 0x1p-12);
  if (name == "toutatis") return toutatis();
  if (name == "flat tetrahedron") return tetrahedron(4, 0x1p-20);
  return tetrahedron(static_cast<std::uint64_t>(name.back() - '0'), 1.0);
}

TEST(SolidIntegrals, AreThoseOfExactArithmetic) {
  for (const auto& [name, triangles, values] : exact_integrals) {
    const TriangleMesh mesh = sample(name);
    ASSERT_EQ(mesh.triangles.size(), triangles) << name;
    const SolidIntegrals found = solid_integrals(mesh);
    const Matrix3d& I = found.inertia;
    const std::array ours{found.volume,
                          found.centroid.x(),
                          found.centroid.y(),
                          found.centroid.z(),
                          I(0, 0),
                          I(1, 1),
                          I(2, 2),
                          I(1, 2),
                          I(0, 2),
                          I(0, 1)};
    for (std::size_t i = 0; i < ours.size(); ++i) {
      // One unit in the last place, because the reference is also rounded.
      EXPECT_NEAR(ours[i], values[i], 2.3e-16 * std::abs(values[i])) << name << ", number " << i;
    }
  }
}

TEST(SolidIntegrals, DoNotDependOnTheOrderOfTheTriangles) {
  TriangleMesh mesh = lumpy_cube(92);
  const SolidIntegrals before = solid_integrals(mesh);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), std::mt19937(3));
  const SolidIntegrals after = solid_integrals(mesh);
  EXPECT_DOUBLE_EQ(before.volume, after.volume);
  EXPECT_LE((before.inertia - after.inertia).norm(), 1e-15 * before.inertia.norm());
}

TEST(SolidIntegrals, IgnoreVerticesOfNoTriangle) {
  TriangleMesh mesh = moved(lumpy_cube(4), {1e4, 1e4, 1e4});
  const SolidIntegrals before = solid_integrals(mesh);
  mesh.vertices.emplace_back(0, 0, 0);
  EXPECT_EQ(solid_integrals(mesh).inertia, before.inertia);
}

/// Returns the error with which a mesh is rejected.
std::string refused_mesh(const TriangleMesh& mesh) {
  try {
    solid_integrals(mesh);
  } catch (const InvalidArgument& error) {
    EXPECT_EQ(error.quantity(), "mesh");
    return error.what();
  }
  return "nothing";
}

TEST(SolidIntegrals, OfWhatIsNoSolidAreRefused) {
  EXPECT_EQ(refused_mesh(lumpy_cube(2)), "nothing");
  EXPECT_THAT(refused_mesh({}), HasSubstr("no triangles"));
  TriangleMesh mesh = lumpy_cube(2);
  mesh.triangles[5][1] = 26;
  EXPECT_THAT(refused_mesh(mesh), HasSubstr("triangle 5 refers to vertex 26, but there are 26"));
  mesh = lumpy_cube(2);
  mesh.vertices[7].y() = std::nan("");
  EXPECT_THAT(refused_mesh(mesh), HasSubstr("vertex 7 is not finite"));
  mesh = lumpy_cube(2);
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_THAT(refused_mesh(mesh), HasSubstr("its volume is -"));
  mesh.triangles.resize(1);
  mesh.triangles.push_back({mesh.triangles[0][1], mesh.triangles[0][0], mesh.triangles[0][2]});
  EXPECT_THAT(refused_mesh(mesh), HasSubstr("its volume is 0"));
  mesh = lumpy_cube(2);
  for (Vector3d& vertex : mesh.vertices) vertex *= 1e100;
  EXPECT_THAT(refused_mesh(mesh), HasSubstr("beyond what double precision holds"));
}

/// Returns the cube from -1 to 1.
TriangleMesh plain_cube(std::uint32_t n) {
  return cube_grid(n, [n](const std::array<std::uint32_t, 3>& place) {
    return Vector3d(2.0 * place[0] / n - 1, 2.0 * place[1] / n - 1, 2.0 * place[2] / n - 1);
  });
}

TEST(ShellIntegrals, OfACubesFaces) {
  const SolidIntegrals wall = shell_integrals(plain_cube(3), 0.1);
  EXPECT_NEAR(wall.volume, 2.4, 1e-15);
  EXPECT_LE(wall.centroid.norm(), 1e-16);
  // Each face has a sixth of the mass. Per mass, the moment about an axis through two faces is 2/3
  // for each of those and 4/3 for each of the others.
  const double moment = 2.4 / 6 * (2 * 2.0 / 3 + 4 * (1 + 1.0 / 3));
  EXPECT_LE((wall.inertia - moment * Matrix3d::Identity()).norm(), 1e-14);
}

TEST(ShellIntegrals, AreTheSameFarAway) {
  const Vector3d shift(4096, -8192, 16384);  // so that the vertices are not rounded
  const SolidIntegrals here = shell_integrals(plain_cube(4), 0.1);
  const SolidIntegrals there = shell_integrals(moved(plain_cube(4), shift), 0.1);
  EXPECT_EQ(there.volume, here.volume);
  EXPECT_EQ(there.centroid, shift);
  EXPECT_LE((there.inertia - here.inertia).norm(), 1e-15 * here.inertia.norm());
}

TEST(ShellIntegrals, AreTheDifferenceOfTwoSolids) {
  const double thickness = 1e-4;
  const auto ball = [](double radius) {
    return cube_grid(8, [radius](const std::array<std::uint32_t, 3>& place) {
      return Vector3d(
          radius *
          Vector3d(place[0] / 4.0 - 1, place[1] / 4.0 - 1, place[2] / 4.0 - 1).normalized());
    });
  };
  const SolidIntegrals inner = solid_integrals(ball(1 - thickness / 2)),
                       outer = solid_integrals(ball(1 + thickness / 2)),
                       wall = shell_integrals(ball(1), thickness);
  // Facets lie within the sphere, so the layer between two of them is thinner.
  EXPECT_NEAR(wall.volume, outer.volume - inner.volume, 0.02 * wall.volume);
  EXPECT_LE((wall.inertia - (outer.inertia - inner.inertia)).norm(), 0.02 * wall.inertia.norm());
}

TEST(ShellIntegrals, OfNoWallAreRefused) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(shell_integrals(plain_cube(1), bad), OutOfRange) << bad;
  }
  EXPECT_THROW(shell_integrals({}, 1), InvalidArgument);
  const TriangleMesh needle{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}, {}};
  EXPECT_THROW(shell_integrals(needle, 1), InvalidArgument) << "no area";
}

TEST(SurfaceArea, OfACube) { EXPECT_DOUBLE_EQ(surface_area(plain_cube(5)), 24); }

/// Returns a mesh with about n facets along its circumference, whose vertices lie on the shape.
TriangleMesh faceted(const Shape& shape, std::uint32_t n) {
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape)) {
    return cube_grid(n / 4, [&](const std::array<std::uint32_t, 3>& place) -> Vector3d {
      const Vector3d p = Vector3d(place[0], place[1], place[2]) / (n / 8.0) - Vector3d::Ones();
      return p.normalized().cwiseProduct(ellipsoid->radii);
    });
  }
  const auto& cylinder = std::get<Cylinder>(shape);
  TriangleMesh mesh;
  const double half = cylinder.length / 2;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    const double x = cylinder.radius * std::cos(angle), y = cylinder.radius * std::sin(angle);
    mesh.vertices.emplace_back(x, y, -half);
    mesh.vertices.emplace_back(x, y, half);
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % n);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    if (i == 0 || i + 1 == n) continue;
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a + 1, b + 1});
  }
  return mesh;
}

/// Returns the greatest relative error of the mass and moments of the faceted shape.
double facet_error(const Shape& shape, std::uint32_t n) {
  const Matrix3d R = so3::exp(Vector3d(0.3, -1, 0.2));
  const std::array whole{Part{shape, 2, {3, -4, 5}, R}},
      facets{Part{make_mesh(faceted(shape, n)), 2, {3, -4, 5}, R}};
  const MassProperties exact = mass_properties(whole), found = mass_properties(facets);
  EXPECT_LE((found.centre_of_mass - exact.centre_of_mass).norm(), 1e-13);
  return std::max(std::abs(found.mass / exact.mass - 1),
                  (found.inertia - exact.inertia).norm() / exact.inertia.norm());
}

TEST(Facets, HaveAnErrorThatFallsWithTheSquareOfTheirSize) {
  for (const Shape& shape : {Shape(Cylinder{1.5, 4}), Shape(Ellipsoid{{1, 2, 3}})}) {
    for (std::uint32_t n = 32; n <= 128; n *= 2) {
      const double slope = std::log2(facet_error(shape, n) / facet_error(shape, 2 * n));
      EXPECT_NEAR(slope, 2, 0.05) << shape.index() << ", " << n << " facets";
    }
  }
  EXPECT_LT(facet_error(Cylinder{1.5, 4}, 25'000), 1e-7) << "10^5 triangles";
}

TEST(Facets, OfABoxAreTheBox) {
  TriangleMesh mesh = plain_cube(3);
  for (Vector3d& vertex : mesh.vertices) vertex = vertex.cwiseProduct(Vector3d(0.5, 1, 1.5));
  const Shape box = Box{{1, 2, 3}}, facets = make_mesh(mesh);
  EXPECT_DOUBLE_EQ(volume(facets), volume(box));
  EXPECT_LE((central_inertia(facets, 3) - central_inertia(box, 3)).norm(), 1e-14);
}

}  // namespace
}  // namespace twrench::body
