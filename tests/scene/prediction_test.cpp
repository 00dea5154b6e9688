#include "scene/prediction.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include "scene/scene.h"

namespace twrench::scene {
namespace {

using body::PrincipalAxes;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(Prediction, OfTheTWrench) {
  const PrincipalAxes wrench =
      body::principal_axes(mass_properties(load_scene("dzhanibekov").body).inertia);
  EXPECT_EQ(prediction(wrench, PrincipalAxes::least, 1),
            "stable about y, wobbles every 16.6 s at 1 rad/s");
  EXPECT_EQ(prediction(wrench, PrincipalAxes::intermediate, 1),
            "unstable about x, doubles every 1.88 s at 1 rad/s");
  EXPECT_EQ(prediction(wrench, PrincipalAxes::greatest, 1),
            "stable about z, wobbles every 7.41 s at 1 rad/s");
  EXPECT_EQ(prediction(wrench, PrincipalAxes::intermediate, 2),
            "unstable about x, doubles every 0.941 s at 2 rad/s");
  EXPECT_EQ(prediction(wrench, PrincipalAxes::intermediate, 1e-4),
            "unstable about x, doubles every 5.23 h at 0.0001 rad/s");
}

TEST(Prediction, InNorwegian) {
  const PrincipalAxes wrench =
      body::principal_axes(mass_properties(load_scene("dzhanibekov").body).inertia);
  EXPECT_EQ(prediction(wrench, PrincipalAxes::intermediate, 1, Language::nb),
            "ustabil om x, dobles på 1.88 s ved 1 rad/s");
  const PrincipalAxes sphere = body::principal_axes(Matrix3d::Identity());
  EXPECT_EQ(prediction(sphere, PrincipalAxes::intermediate, 1, Language::nb), "nøytral om y");
}

TEST(Prediction, OfASphereAndOfABodyAtRestIsNone) {
  const PrincipalAxes sphere = body::principal_axes(Matrix3d::Identity());
  EXPECT_EQ(prediction(sphere, PrincipalAxes::intermediate, 1), "neutral about y");
  const PrincipalAxes box = body::principal_axes(Vector3d(1, 2, 3).asDiagonal());
  EXPECT_EQ(prediction(box, PrincipalAxes::intermediate, 0), "neutral about y");
}

TEST(Prediction, NamesAxesThatAreNotTheBodysByTheirMoments) {
  const Matrix3d R = so3::exp(Vector3d(0, 0, 0.5));
  Matrix3d inertia = R * Vector3d(1, 2, 3).asDiagonal() * R.transpose();
  inertia = 0.5 * (inertia + inertia.transpose()).eval();
  const PrincipalAxes principal = body::principal_axes(inertia);
  EXPECT_EQ(axis_name(principal.axes, 0), "I1");
  EXPECT_EQ(axis_name(principal.axes, 1), "I2");
  EXPECT_EQ(axis_name(principal.axes, 2), "z");
}

}  // namespace
}  // namespace twrench::scene
