#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/math/so3.h>

#include <Eigen/LU>
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

std::vector<Part> three_parts() {
  return {{Cylinder{1, 5}, 2, {1, 2, 3}, so3::exp(Vector3d(0.3, 0.4, -1))},
          {Box{{1, 2, 4}}, 3, {-4, 0, 1}, so3::exp(Vector3d(1, -0.2, 0))},
          {Ellipsoid{{1, 0.5, 2}}, 5, {0, 3, -2}, so3::exp(Vector3d(-2, 0.1, 0.7))}};
}

/// Parts with a centroid other than their origin and axes other than their principal axes.
std::vector<Part> uneven_parts() {
  return {{Cone{1, 3, 0.5}, 2, {1, 2, 3}, so3::exp(Vector3d(0.3, 0.4, -1))},
          {make_mesh(moved(tetrahedron(2, 1.0), {1, 2, 0})),
           300,
           {-4, 0, 1},
           so3::exp(Vector3d(1, -0.2, 0))}};
}

TEST(MassProperties, DoNotDependOnWhereTheSceneWasDrawn) {
  std::vector<Part> parts = three_parts();
  for (const Part& part : uneven_parts()) parts.push_back(part);
  const Matrix3d R = so3::exp(Vector3d(0.5, -1.5, 0.8));
  const Vector3d shift(10, -20, 5);
  std::vector<Part> moved = parts;
  for (Part& part : moved) {
    part.position = R * part.position + shift;
    part.body_from_part = R * part.body_from_part;
  }
  const MassProperties a = mass_properties(parts), b = mass_properties(moved);
  EXPECT_NEAR(a.mass, b.mass, 1e-12 * a.mass);
  EXPECT_LE((b.centre_of_mass - (R * a.centre_of_mass + shift)).norm(), 1e-13);
  EXPECT_LE((b.inertia - R * a.inertia * R.transpose()).norm(), 1e-12 * a.inertia.norm());
  EXPECT_LE((a.moments - b.moments).norm(), 1e-12 * a.moments.norm());
}

TEST(MassProperties, ABoxCutInTwoIsTheSameBox) {
  const Matrix3d Id = Matrix3d::Identity();
  const std::vector<Part> whole{{Box{{4, 2, 3}}, 2, {0, 0, 0}, Id}};
  const std::vector<Part> halves{{Box{{1, 2, 3}}, 2, {-1.5, 0, 0}, Id},
                                 {Box{{3, 2, 3}}, 2, {0.5, 0, 0}, Id}};
  EXPECT_LE((mass_properties(whole).inertia - mass_properties(halves).inertia).norm(), 1e-12);
}

TEST(MassProperties, OfAPartOfAMeshTogetherAreThoseOfTheWhole) {
  const std::vector<Part> whole{
      {make_mesh(tetrahedron(2, 1.0)), 2, {0, 0, 0}, Matrix3d::Identity()}};
  // A point inside splits it into four tetrahedra, each with its own frame.
  const TriangleMesh mesh = tetrahedron(2, 1.0);
  const Vector3d middle = mass_properties(whole).centre_of_mass;
  std::vector<Part> pieces;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Matrix3d R = so3::exp(Vector3d(a, b, c));
    const Vector3d position(b, c, a);
    TriangleMesh piece{{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], middle},
                       {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}},
                       {}};
    for (Vector3d& v : piece.vertices) v = R.transpose() * (v - position);
    pieces.push_back({make_mesh(piece), 2, position, R});
  }
  const MassProperties a = mass_properties(whole), b = mass_properties(pieces);
  EXPECT_NEAR(a.mass, b.mass, 1e-14 * a.mass);
  EXPECT_LE((b.centre_of_mass - a.centre_of_mass).norm(), 1e-14);
  EXPECT_LE((b.inertia - a.inertia).norm(), 1e-12 * a.inertia.norm());
}

TEST(MassProperties, PrincipalAxesDiagonalise) {
  const MassProperties body = mass_properties(three_parts());
  const Matrix3d D = body.axes.transpose() * body.inertia * body.axes;
  EXPECT_LE((D - Matrix3d(body.moments.asDiagonal())).norm(), 1e-12 * body.inertia.norm());
  EXPECT_NEAR(body.axes.determinant(), 1.0, 1e-14);
  EXPECT_LE(body.moments[0], body.moments[1]);
  EXPECT_LE(body.moments[1], body.moments[2]);
}

/// Returns the quantity that the error about the parts names.
std::string refused(const std::vector<Part>& parts) {
  try {
    mass_properties(parts);
  } catch (const InvalidArgument& error) {
    return error.quantity();
  }
  return "nothing";
}

TEST(MassProperties, OfPartsThatCannotBeAreRefused) {
  EXPECT_EQ(refused(three_parts()), "nothing");
  EXPECT_EQ(refused({}), "parts");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, std::nan(""), infinity}) {
    auto parts = three_parts();
    parts[1].density = bad;
    EXPECT_EQ(refused(parts), "density") << bad;
    parts[1] = {Cylinder{bad, 1}, 1, Vector3d::Zero(), Matrix3d::Identity()};
    EXPECT_EQ(refused(parts), "radius") << bad;
    parts[1].shape = Cylinder{1, bad};
    EXPECT_EQ(refused(parts), "length") << bad;
    parts[1].shape = Box{{1, bad, 1}};
    EXPECT_EQ(refused(parts), "size") << bad;
    parts[1].shape = Ellipsoid{{1, 1, bad}};
    EXPECT_EQ(refused(parts), "radii") << bad;
    if (std::isfinite(bad)) continue;
    parts[1] = three_parts()[1];
    parts[1].position.y() = bad;
    EXPECT_EQ(refused(parts), "position") << bad;
  }
}

/// Returns the quantity that the error about a body of one shape names.
std::string refused_shape(const Shape& shape) {
  return refused({{shape, 1, Vector3d::Zero(), Matrix3d::Identity()}});
}

TEST(MassProperties, OfShapesThatCannotBeAreRefused) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(refused_shape(Cone{bad, 1}), "radius") << bad;
    EXPECT_EQ(refused_shape(Cone{1, bad}), "length") << bad;
    EXPECT_EQ(refused_shape(Capsule{bad, 1}), "radius") << bad;
    EXPECT_EQ(refused_shape(Capsule{1, bad}), "length") << bad;
    EXPECT_EQ(refused_shape(Torus{2, bad}), "tube_radius") << bad;
    EXPECT_EQ(refused_shape(Tube{2, bad, 1}), "inner_radius") << bad;
    EXPECT_EQ(refused_shape(Tube{2, 1, bad}), "length") << bad;
  }
  EXPECT_EQ(refused_shape(Cone{1, 1, -1}), "top_radius");
  EXPECT_EQ(refused_shape(Cone{1, 1, std::nan("")}), "top_radius");
  EXPECT_EQ(refused_shape(Torus{1, 1}), "tube_radius") << "it meets itself";
  EXPECT_EQ(refused_shape(Torus{std::nan(""), 1}), "radius");
  EXPECT_EQ(refused_shape(Tube{1, 1, 1}), "inner_radius") << "no wall";
  EXPECT_EQ(refused_shape(Tube{std::nan(""), 1, 1}), "radius");
  EXPECT_EQ(refused_shape(Mesh{}), "mesh");
  EXPECT_EQ(refused_shape(Cone{1, 2, 3}), "nothing");
}

TEST(MassProperties, OfAPartThatIsNotTurnedButBentAreRefused) {
  auto parts = three_parts();
  parts[0].body_from_part.setZero();
  EXPECT_EQ(refused(parts), "body_from_part");
  parts[0].body_from_part = -Matrix3d::Identity();
  EXPECT_EQ(refused(parts), "body_from_part") << "a reflection";
  parts[0].body_from_part = 1.001 * Matrix3d::Identity();
  EXPECT_EQ(refused(parts), "body_from_part");
  parts[0].body_from_part(1, 1) = std::nan("");
  EXPECT_EQ(refused(parts), "body_from_part");
}

TEST(MassProperties, ThatOverflowAreRefused) {
  EXPECT_EQ(refused({{Box{{1e150, 1, 1}}, 1e200, {0, 0, 0}, Matrix3d::Identity()}}), "parts");
}

TEST(PrincipalAxes, OfAMatrixThatIsNoInertiaAreRefused) {
  Matrix3d inertia = Vector3d(1, 2, 3).asDiagonal();
  inertia(2, 1) = 0.1;
  EXPECT_THROW(principal_axes(inertia), InvalidArgument) << "not symmetric";
  inertia(2, 1) = inertia(1, 2) = std::nan("");
  EXPECT_THROW(principal_axes(inertia), OutOfRange);
}

TEST(PrincipalAxes, OrderAndSignAreDefinite) {
  const Matrix3d R = so3::exp(Vector3d(0.4, 1.1, -0.3));
  const Matrix3d inertia = R * Vector3d(3, 1, 2).asDiagonal() * R.transpose();
  const PrincipalAxes principal = principal_axes((inertia + inertia.transpose()) / 2);
  EXPECT_LE((principal.moments - Vector3d(1, 2, 3)).norm(), 1e-14);
  for (int i = 0; i < 2; ++i) {
    Eigen::Index largest = 0;
    principal.axes.col(i).cwiseAbs().maxCoeff(&largest);
    EXPECT_GT(principal.axes(largest, i), 0);
  }
  EXPECT_NEAR(principal.axes.determinant(), 1, 1e-14);
}

TEST(PrincipalAxes, OfADiagonalMatrixAreExact) {
  for (const Vector3d& moments : {Vector3d(1, 2, 3), Vector3d(3, 1, 2), Vector3d(2, 3, 1),
                                  Vector3d(3, 2, 1), Vector3d(1, 1, 1), Vector3d(2, 1, 2)}) {
    const PrincipalAxes p = principal_axes(moments.asDiagonal());
    EXPECT_EQ(Matrix3d(p.axes * p.moments.asDiagonal() * p.axes.transpose()),
              Matrix3d(moments.asDiagonal()));
    EXPECT_EQ(p.axes.determinant(), 1);
  }
}

TEST(EquimomentalPoints, HaveThePartsMassCentreAndInertia) {
  std::vector<Part> parts = three_parts();
  for (const Part& part : uneven_parts()) parts.push_back(part);
  for (const Part& part : parts) {
    const MassProperties expected = mass_properties({&part, 1});
    double mass = 0;
    Vector3d centre = Vector3d::Zero();
    Matrix3d inertia = Matrix3d::Zero();
    for (const auto& [m, r] : equimomental_points(part)) {
      const Vector3d d = r - expected.centre_of_mass;
      mass += m;
      centre += m / expected.mass * r;
      inertia += m * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
    }
    EXPECT_NEAR(mass, expected.mass, 1e-14 * expected.mass);
    EXPECT_LE((centre - expected.centre_of_mass).norm(), 1e-14);
    EXPECT_LE((inertia - expected.inertia).norm(), 1e-14 * expected.inertia.norm());
  }
}

TEST(EquimomentalPoints, OfACylinderHoldTheCentresOfItsEnds) {
  const Part part = three_parts()[0];
  const auto points = equimomental_points(part);
  const Vector3d half = 2.5 * part.body_from_part.col(2);
  EXPECT_LE((points[4].position - (part.position + half)).norm(), 1e-14);
  EXPECT_LE((points[5].position - (part.position - half)).norm(), 1e-14);
}

}  // namespace
}  // namespace twrench::body
