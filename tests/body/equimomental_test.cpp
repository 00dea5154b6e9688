#include <gtest/gtest.h>
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/math/so3.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace twrench::body {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Form {
  std::string name;
  std::function<std::vector<Part>(const Matrix3d& inertia)> parts;
};

const std::vector<Form>& forms() {
  static const std::vector<Form> all{
      {"box", [](const Matrix3d& I) { return std::vector<Part>{equimomental_box(I)}; }},
      {"ellipsoid", [](const Matrix3d& I) { return std::vector<Part>{equimomental_ellipsoid(I)}; }},
      {"cross",
       [](const Matrix3d& I) {
         const auto parts = equimomental_cross(I);
         return std::vector<Part>(parts.begin(), parts.end());
       }},
  };
  return all;
}

Matrix3d diagonal(double x, double y, double z) { return Vector3d(x, y, z).asDiagonal(); }

// Moments of a sphere, of rods, of plates close to the limit of the triangle inequality, and 3, 4,
// 5 in several orders.
TEST(Equimomental, HasTheMomentsItWasMadeFrom) {
  for (const Form& form : forms()) {
    for (const Vector3d& moments :
         {Vector3d(1, 1, 1), Vector3d(3, 4, 5), Vector3d(5, 4, 3), Vector3d(4, 5, 3),
          Vector3d(900, 700, 1500), Vector3d(1e-3, 1, 1), Vector3d(1, 1e-2, 1),
          Vector3d(1, 1, 1.999), Vector3d(1, 1.9, 2.8), Vector3d(1, 2, 2),
          Vector3d(3e-60, 4e-60, 5e-60), Vector3d(3e30, 4e30, 5e30)}) {
      const MassProperties body = mass_properties(form.parts(moments.asDiagonal()));
      EXPECT_LE((body.inertia - Matrix3d(moments.asDiagonal())).norm(), 1e-12 * moments.norm())
          << form.name << " " << moments.transpose();
      EXPECT_LE(body.centre_of_mass.norm(), 1e-12 * std::pow(moments.norm(), 0.2)) << form.name;
    }
  }
}

TEST(Equimomental, LiesAlongThePrincipalAxes) {
  const Matrix3d axes = so3::exp(Vector3d(0.3, -0.7, 1.1));
  for (const Form& form : forms()) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const Matrix3d turned = axes * diagonal(3 * scale, 4 * scale, 5 * scale) * axes.transpose();
      const Matrix3d inertia = (turned + turned.transpose()) / 2;
      const MassProperties body = mass_properties(form.parts(inertia));
      EXPECT_LE((body.inertia - inertia).norm(), 1e-12 * inertia.norm()) << form.name;
    }
  }
}

TEST(Equimomental, OfAMomentThatIsNotPositiveIsRefused) {
  for (const Form& form : forms()) {
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      EXPECT_THROW(form.parts(diagonal(1, bad, 1)), OutOfRange) << form.name << " " << bad;
    }
  }
}

TEST(Equimomental, OfAnImpossibleBodyIsNearlyFlat) {
  const Vector3d size = std::get<Box>(equimomental_box(diagonal(1, 1, 5)).shape).size;
  const Vector3d radii = std::get<Ellipsoid>(equimomental_ellipsoid(diagonal(1, 1, 5)).shape).radii;
  for (const Vector3d& lengths : {size, radii}) {
    EXPECT_TRUE(lengths.allFinite());
    EXPECT_GT(lengths.minCoeff(), 0);
    EXPECT_LT(lengths.z(), 0.01 * lengths.x());
  }
  for (const Part& part : equimomental_cross(diagonal(1, 1, 5))) {
    const double thickness = std::holds_alternative<Box>(part.shape)
                                 ? std::get<Box>(part.shape).size.z()
                                 : std::get<Cylinder>(part.shape).length;
    EXPECT_GT(thickness, 0);
    EXPECT_LT(thickness, 0.02 * bounding_radius(equimomental_cross(diagonal(1, 1, 5))[0].shape));
  }
}

// The heavy discs lie on the axis of least moment and the light ones on the axis of intermediate
// moment. All lie flat in the plane normal to the axis of greatest moment.
TEST(EquimomentalCross, LiesAsTaoSays) {
  const auto parts = equimomental_cross(diagonal(4, 5, 3));
  const double arm = std::get<Box>(parts[0].shape).size.x() / 2;
  EXPECT_LE((parts[3].position.cwiseAbs() - Vector3d(0, 0, arm)).norm(), 1e-12 * arm);
  EXPECT_LE((parts[5].position.cwiseAbs() - Vector3d(arm, 0, 0)).norm(), 1e-12 * arm);
  EXPECT_EQ(parts[3].position, -parts[4].position);
  EXPECT_EQ(parts[5].position, -parts[6].position);
  const auto radius = [&](std::size_t i) { return std::get<Cylinder>(parts[i].shape).radius; };
  EXPECT_GT(radius(3), 1.1 * radius(5));
  EXPECT_EQ(radius(3), radius(4));
  EXPECT_GT(radius(5), radius(2) / 2);
  for (const Part& part : parts) {
    EXPECT_EQ(part.body_from_part.col(2).cwiseAbs(), Vector3d::UnitY());
    EXPECT_EQ(part.body_from_part.determinant(), 1);
  }
}

// Coplanar faces would flicker.
TEST(EquimomentalCross, HasArmsThinnerThanItsDiscs) {
  for (const Vector3d& moments : {Vector3d(3, 4, 5), Vector3d(1, 1, 1), Vector3d(1, 2, 3)}) {
    const auto parts = equimomental_cross(moments.asDiagonal());
    const double arms = std::get<Box>(parts[0].shape).size.z();
    EXPECT_EQ(arms, std::get<Box>(parts[1].shape).size.z());
    EXPECT_LT(arms, 0.9 * std::get<Cylinder>(parts[2].shape).length);
    // The hub covers the crossing of the arms.
    EXPECT_GT(
        std::get<Cylinder>(parts[2].shape).radius,
        std::hypot(std::get<Box>(parts[0].shape).size.y(), std::get<Box>(parts[1].shape).size.x()) /
            2);
  }
}

}  // namespace
}  // namespace twrench::body
