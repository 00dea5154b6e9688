// The errors and notes about meshes that do not bound a solid.
#include "mesh/diagnosis.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "mesh/mesh_file.h"
#include "mesh/overlaps.h"
#include "mesh/refusal.h"
#include "mesh/samples.h"
#include "mesh/topology.h"
#include "sanitizers.h"

namespace twrench::mesh {
namespace {

using body::TriangleMesh;
using Eigen::Vector3d;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

MeshFile read(const TriangleMesh& mesh, const ReadOptions& options = {.scale = 1.0}) {
  return read_mesh(obj_of(mesh), "a.obj", options);
}

/// Returns the error and the remedy, separated by a bar.
std::string refused(const TriangleMesh& mesh, const ReadOptions& options = {.scale = 1.0}) {
  try {
    read(mesh, options);
  } catch (const InvalidArgument& error) {
    return std::string(error.what()) + " | " + error.remedy();
  }
  return "nothing";
}

TEST(Diagnosis, OfAnOpenSurfaceNamesItsEdgesAndItsGap) {
  TriangleMesh mesh = cube({0, 0, 0}, 1);
  mesh.triangles.pop_back();
  EXPECT_THAT(refused(mesh, {.scale = 0.1}),
              AllOf(StartsWith("a.obj: the surface is open at 3 edges, the first from (0, 0, 1) to "
                               "(0, 1, 0); the largest gap is 0.1 cm"),
                    HasSubstr("| close it; or make it a wall: shell = THICKNESS, in cm")));
}

// In shape models of asteroids, each triangle at a pole may have a separate vertex there.
TEST(Diagnosis, OffersTheToleranceThatClosesAGap) {
  const TriangleMesh mesh = ball_with_open_poles(72, 36, 3e-7);
  try {
    read(mesh);
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_EQ(error.reason(), MeshError::Reason::open);
    EXPECT_THAT(error.what(), HasSubstr("open at 288 edges"));
    ASSERT_TRUE(error.weld());
    EXPECT_LE(*error.weld(), 2e-6);
    EXPECT_THAT(error.remedy(), StartsWith("weld = 5e-07 closes it"));
    const MeshFile closed = read(mesh, {.scale = 1.0, .weld = *error.weld()});
    EXPECT_EQ(closed.open_edges, 0U);
    EXPECT_EQ(closed.shape.surface->triangles.size(), mesh.triangles.size());
    EXPECT_THAT(closed.notes, ElementsAre(HasSubstr("142 vertices were joined")));
    EXPECT_NEAR(closed.shape.integrals.volume, 4.18, 0.02);
  }
}

TEST(Diagnosis, OffersNoWeldingThatWouldFoldTheMesh) {
  TriangleMesh mesh = ball_with_open_poles(72, 36, 0);
  mesh.triangles.erase(mesh.triangles.begin() + 300);  // a hole of the size of a triangle
  EXPECT_THAT(refused(mesh), AllOf(HasSubstr("open at 3 edges"), HasSubstr("| close it; or")));
}

TEST(Diagnosis, AnOpenSurfaceMayBeAWall) {
  TriangleMesh mesh = cube({0, 0, 0}, 1);
  mesh.triangles.resize(10);
  const MeshFile file = read(mesh, {.scale = 10.0, .shell = 0.1});
  EXPECT_EQ(file.open_edges, 4U);
  EXPECT_DOUBLE_EQ(file.area, 500);
  EXPECT_DOUBLE_EQ(file.shape.integrals.volume, 50);
  EXPECT_EQ(file.shape.shell, 0.1);
}

TEST(Diagnosis, OfEdgesOfMoreThanTwoTriangles) {
  TriangleMesh mesh = cube({0, 0, 0}, 1);
  mesh.vertices.emplace_back(0.5, 0.5, 2);
  mesh.triangles.push_back({4, 5, 8});
  EXPECT_THAT(refused(mesh), HasSubstr("not manifold: more than two triangles meet at 1 edge, from "
                                       "(0, 0, 1) to (1, 0, 1); it is also open at 2 edges"));
  const TriangleMesh touching = joined(cube({0, 0, 0}, 1), cube({1, 1, 0}, 1));
  TriangleMesh ends_within = touching;
  ends_within.triangles.pop_back();
  EXPECT_THAT(refused(ends_within), HasSubstr("the surface is open at 3 edges"));
  mesh = touching;
  mesh.triangles.erase(mesh.triangles.begin() + 17);  // one of the four at the common edge
  EXPECT_THAT(refused(mesh), HasSubstr("more than two triangles meet at 1 edge, from (1, 1, 0) to "
                                       "(1, 1, 1); it is also open at 2 edges"));
}

TEST(Diagnosis, OfBodiesThatOverlapAtAnEdge) {
  EXPECT_THAT(refused(joined(cube({0, 0, 0}, 1), turned(cube({1, 1, 0}, 1)))),
              AllOf(HasSubstr("the triangles that meet at 1 edge, from (1, 1, 0) to (1, 1, 1) are "
                              "turned over or lie within a volume that counts already"),
                    HasSubstr("| unite the parts that overlap there")));
  EXPECT_THAT(
      refused(joined(cube({0, 0, 0}, 1), cube({0, 0, 0}, 1)), {.scale = 1.0, .search = false}),
      HasSubstr("the triangles that meet at 18 edges, the first from"));
}

/// Returns the tetrahedron of four points, with its inside within.
TriangleMesh tetrahedron(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                         const Vector3d& d) {
  TriangleMesh mesh;
  mesh.vertices = {a, b, c, d};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  return (b - a).cross(c - a).dot(d - a) > 0 ? mesh : turned(mesh);
}

/// Returns half of the unit cube, cut along the diagonal from (0, 0) to (1, 1).
TriangleMesh half_cube(bool lower) {
  TriangleMesh mesh;
  const Vector3d corner = lower ? Vector3d(1, 0, 0) : Vector3d(0, 1, 0);
  mesh.vertices = {{0, 0, 0}, corner, {1, 1, 0}, {0, 0, 1}, corner + Vector3d(0, 0, 1), {1, 1, 1}};
  // The two halves have different diagonals in their common face.
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  mesh.triangles.push_back(lower ? std::array{0U, 5U, 2U} : std::array{0U, 3U, 2U});
  mesh.triangles.push_back(lower ? std::array{0U, 3U, 5U} : std::array{2U, 3U, 5U});
  return lower ? mesh : turned(mesh);
}

/// Expects that a file with all bodies has the sum of their integrals.
void expect_sum(const std::vector<TriangleMesh>& bodies, const char* what) {
  TriangleMesh all;
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const auto about = [](const Vector3d& d) -> Eigen::Matrix3d {
    return d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose();
  };
  for (const TriangleMesh& body : bodies) {
    all = joined(all, body);
    const body::SolidIntegrals own =
        signed_volume(body) > 0 ? body::solid_integrals(body) : body::solid_integrals(turned(body));
    const double sign = signed_volume(body) > 0 ? 1 : -1;
    volume += sign * own.volume;
    first += sign * own.volume * own.centroid;
    second += sign * (own.inertia + own.volume * about(own.centroid));
  }
  SCOPED_TRACE(what);
  for (const bool is_turned : {false, true}) {
    const MeshFile file = read(is_turned ? turned(all) : all);
    const body::SolidIntegrals& found = file.shape.integrals;
    EXPECT_NEAR(found.volume, volume, 1e-14 * volume);
    EXPECT_LE((found.centroid - first / volume).norm(), 1e-14);
    EXPECT_LE((found.inertia - second + volume * about(first / volume)).norm(),
              1e-14 * second.norm());
    EXPECT_EQ(file.open_edges, 0U);
    EXPECT_EQ(file.notes.size(), is_turned ? 1U : 0U);
  }
}

TEST(Diagnosis, LetsBodiesShareEdgesFacesAndCorners) {
  const TriangleMesh unit = cube({0, 0, 0}, 1);
  expect_sum({unit, cube({1, 1, 0}, 1)}, "an edge");
  expect_sum({unit, cube({1, 1, 0}, 1), cube({2, 0, 0}, 1)}, "edges, and a corner or an edge each");
  expect_sum({unit, cube({1, 0, 0}, 1), cube({0, 1, 0}, 1), cube({1, 1, 0}, 1)},
             "four around an edge");
  expect_sum({half_cube(true), half_cube(false)}, "the face of a cut");
  const Vector3d zero = Vector3d::Zero();
  const TriangleMesh first = tetrahedron(zero, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  expect_sum({first, tetrahedron(zero, {-1, 0, 0}, {0, -2, 0}, {0, 0, -1})}, "a corner");
  expect_sum({first, tetrahedron(zero, {-1, 0, 0}, {0, -2, 0}, {0, 0, 1})}, "an edge");
  expect_sum({first, tetrahedron(zero, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1})}, "a face");
  // A cavity that touches the surface from within along an edge.
  expect_sum({cube({0, 0, 0}, 3), turned(tetrahedron(zero, {0, 0, 3}, {1, 2, 1}, {2, 1, 1}))},
             "a cavity");
}

TEST(Diagnosis, OfTrianglesThatDisagree) {
  TriangleMesh mesh = cube({0, 0, 0}, 1);
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_THAT(refused(mesh), AllOf(HasSubstr("disagree on which side is outside at 3 edges"),
                                   HasSubstr("recalculating normals")));
}

TEST(Diagnosis, TurnsOverWhatIsInsideOut) {
  const MeshFile file = read(turned(cube({0, 0, 0}, 1)));
  EXPECT_THAT(file.notes, ElementsAre("it was inside out and has been turned over"));
  EXPECT_EQ(file.shape.integrals.volume, 1);
  const TriangleMesh hollow = joined(cube({0, 0, 0}, 3), turned(cube({1, 1, 1}, 1)));
  EXPECT_THAT(read(hollow).notes, IsEmpty()) << "a cavity";
  EXPECT_EQ(read(hollow).shape.integrals.volume, 26);
  EXPECT_EQ(read(hollow).components, 2U);
  EXPECT_EQ(read(turned(hollow)).shape.integrals.volume, 26);
  const TriangleMesh nested =
      joined(joined(cube({0, 0, 0}, 5), turned(cube({1, 1, 1}, 3))), cube({2, 2, 2}, 1));
  EXPECT_EQ(read(nested).shape.integrals.volume, 99) << "a body in the cavity";
}

TEST(Diagnosis, OfComponentsThatDisagree) {
  EXPECT_THAT(refused(joined(cube({0, 0, 0}, 2), turned(cube({5, 0, 0}, 1)))),
              HasSubstr("its 2 components disagree: the one at (5, 1, 0) is turned the other way "
                        "than the rest"));
  EXPECT_THAT(refused(joined(cube({0, 0, 0}, 3), cube({1, 1, 1}, 1))),
              HasSubstr("the one at (1, 1, 1) is within another and turned the same way"));
  EXPECT_EQ(read(joined(cube({0, 0, 0}, 1), cube({5, 0, 0}, 1))).shape.integrals.volume, 2);
}

TEST(Diagnosis, OfASurfaceThatPassesThroughItself) {
  for (const Vector3d& shift : {Vector3d(0.5, 0.5, 0.5), Vector3d(0.3, 0.4, 0.7),
                                Vector3d(0.5, 0.25, 0), Vector3d(0.95, 0.95, 0.95)}) {
    EXPECT_THAT(refused(joined(cube({0, 0, 0}, 1), cube(shift, 1))),
                AllOf(StartsWith("a.obj: it intersects itself: "), HasSubstr("unite the parts")))
        << shift.transpose();
  }
  EXPECT_THAT(refused(joined(ball_with_open_poles(64, 32, 0),
                             moved(ball_with_open_poles(64, 32, 0), {1.9, 0.1, 0.2}))),
              HasSubstr("it intersects itself"));
  TriangleMesh folded = cube({0, 0, 0}, 1);
  folded.vertices[6] = {0.5, 0.5, -2};  // a corner pulled through the opposite face
  EXPECT_THAT(refused(folded), HasSubstr("it intersects itself"));
}

/// Returns a cylinder with a fan of very long triangles at each end.
TriangleMesh cylinder(std::uint32_t sides) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 1);
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    if (i == 0 || i + 1 == sides) continue;
    mesh.triangles.push_back({0, b, a});
    mesh.triangles.push_back({1, a + 1, b + 1});
  }
  return mesh;
}

TEST(Diagnosis, OfASurfaceThatEnclosesNothing) {
  // The face connects every other one of seven points. Rounding leaves a small volume.
  std::string star;
  for (int i = 0; i < 7; ++i) {
    const double angle = 4 * i * 3.14159265358979 / 7;
    star += fmt::format("v {} {} {}\n", std::cos(angle) + 0.1, 0.6 * std::sin(angle),
                        0.8 * std::sin(angle));
  }
  for (const char* faces :
       {"f 1 2 3 4 5 6 7\nf 7 6 5 4 3 2 1\n", "f 7 6 5 4 3 2 1\nf 1 2 3 4 5 6 7\n"}) {
    EXPECT_EQ(
        refusal(star + faces, "a.obj"),
        "2 a.obj: it encloses no volume: its faces lie upon each other, or one crosses itself");
  }
  // A sheet with a thickness of a millionth of its size has a volume.
  TriangleMesh sheet = cube({0, 0, 0}, 1);
  for (Vector3d& vertex : sheet.vertices) vertex.z() *= 1e-6;
  EXPECT_EQ(refusal(obj_of(sheet), "a.obj"), "nothing");
}

// Needles that all cross a ball, so that each is close to nearly all others.
TEST(Diagnosis, CountsItsWork) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  std::mt19937 random(1);
  const auto point = [&] {
    const auto part = [&] { return static_cast<double>(random()) * 0x1p-32 - 0.5; };
    return Vector3d(part(), part(), part()).normalized().eval();
  };
  TriangleMesh needles;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const Vector3d from = point(), to = point(), side = from.cross(to).normalized() * 1e-4;
    const std::uint32_t a = 4 * i, b = a + 1, c = a + 2, d = a + 3;
    needles.vertices.insert(needles.vertices.end(),
                            {from, to, from + side, from + side.cross(to - from)});
    needles.triangles.insert(needles.triangles.end(), {{a, b, c}, {a, d, b}, {a, c, d}, {b, d, c}});
  }
  const TriangleTree tree(needles);
  Allowance small(1'000'000), large(1'000'000'000);
  EXPECT_TRUE(find_crossings(tree, small).is_incomplete);
  EXPECT_TRUE(small.is_used_up());
  EXPECT_FALSE(find_crossings(tree, large).is_incomplete);
  Allowance none(0);
  none.take(1);
  EXPECT_FALSE(misplaced_component(tree, topology(needles), false, none));
}

TEST(Diagnosis, IsNotStoppedByAFan) {
  if (has_sanitizers) GTEST_SKIP() << "takes long for large meshes";
  EXPECT_THAT(read(cylinder(25'000)).notes, IsEmpty()) << "all in one plane";
  TriangleMesh oblique = cylinder(400);
  for (Vector3d& v : oblique.vertices) v.z() += v.x() / 3 + v.y() / 7;
  EXPECT_THAT(read(oblique).notes, IsEmpty());
  TriangleMesh large = cylinder(8000);
  for (Vector3d& v : large.vertices) v.z() += v.x() / 3 + v.y() / 7;
  const MeshFile file = read(large);
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("not searched for triangles that cross")));
  EXPECT_NEAR(file.shape.integrals.volume, std::numbers::pi, 1e-6);
}

TEST(Diagnosis, LetsPartsTouch) {
  EXPECT_EQ(read(joined(cube({0, 0, 0}, 1), cube({1, 0.25, 0.25}, 1))).shape.integrals.volume, 2);
  EXPECT_EQ(read(joined(cube({0, 0, 0}, 1), cube({1, 1, 1}, 1))).shape.integrals.volume, 2);
  TriangleMesh edge = cube({0, 0, 0}, 1);  // turned about x and y, it stands on an edge
  for (Vector3d& v : edge.vertices) v = {v.x(), v.y() - v.z(), 1 + v.y() + v.z()};
  EXPECT_NEAR(read(joined(cube({0, 0, 0}, 1), moved(edge, {0.25, 0.5, 0}))).shape.integrals.volume,
              3, 1e-15);
}

TEST(Diagnosis, IsTheSameFarAway) {
  const Vector3d far(8192, -16384, 4096);
  const TriangleMesh mesh = ball_with_open_poles(64, 32, 0);
  EXPECT_THAT(read(moved(mesh, far)).notes, IsEmpty());
  EXPECT_THAT(read(turned(moved(mesh, far))).notes, ElementsAre(HasSubstr("inside out")));
  EXPECT_THAT(refused(moved(joined(cube({0, 0, 0}, 1), cube({0.5, 0.5, 0.5}, 1)), far)),
              HasSubstr("intersects itself"));
}

TEST(Diagnosis, LeavesTrianglesWithoutAreaOut) {
  TriangleMesh mesh = cube({0, 0, 0}, 1);
  mesh.triangles.push_back({0, 0, 1});
  const MeshFile file = read(mesh);
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("1 triangles have no area")));
  EXPECT_EQ(file.shape.surface->triangles.size(), 12U);
}

}  // namespace
}  // namespace twrench::mesh
