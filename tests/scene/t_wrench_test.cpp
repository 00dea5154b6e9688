#include <gtest/gtest.h>

#include <Eigen/Core>
#include <numbers>

#include "scene/scene.h"

namespace twrench::scene {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

TEST(TWrench, HasTheSpecificationsMassProperties) {
  const body::MassProperties wrench = mass_properties(load_scene("dzhanibekov").body);
  const double M1 = pi * 8 * 6.7, M2 = pi * 4 * 6.7;                                    // R = 1
  const double Ixx = M1 / 4 + M1 * 64 / 12 + M2 / 2;                                    // eq. (46)
  const double Iyy = M1 + M2 * 16 / 4 + M1 / 2 + M2 / 4 + M2 * 16 / 12;                 // eq. (47)
  const double Izz = M1 + M2 * 16 / 4 + M1 / 4 + M1 * 64 / 12 + M2 / 4 + M2 * 16 / 12;  // (48)
  EXPECT_NEAR(wrench.mass, 12 * pi * 6.7, 1e-12 * wrench.mass);
  EXPECT_EQ(wrench.centre_of_mass, Vector3d::Zero());
  EXPECT_NEAR(wrench.inertia(0, 0), Ixx, 1e-12 * Ixx);
  EXPECT_NEAR(wrench.inertia(1, 1), Iyy, 1e-12 * Iyy);
  EXPECT_NEAR(wrench.inertia(2, 2), Izz, 1e-12 * Izz);
  EXPECT_TRUE(wrench.inertia.isDiagonal(0.0)) << wrench.inertia;
  // The values that the specification prints, and the first sixteen digits of the 25-digit
  // reference.
  EXPECT_NEAR(wrench.inertia(0, 0), 982.2713030224087, 1e-12 * Ixx);
  EXPECT_NEAR(wrench.inertia(1, 1), 722.6710300807721, 1e-12 * Iyy);
  EXPECT_NEAR(wrench.inertia(2, 2), 1578.650308428871, 1e-12 * Izz);
  // Iyy < Ixx < Izz: x is the intermediate axis.
  EXPECT_EQ(wrench.axes.col(0).cwiseAbs(), Vector3d::UnitY());
  EXPECT_EQ(wrench.axes.col(1).cwiseAbs(), Vector3d::UnitX());
}

}  // namespace
}  // namespace twrench::scene
