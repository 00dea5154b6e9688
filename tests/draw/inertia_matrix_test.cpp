// A body given by an inertia matrix is drawn along its principal axes. It looks like a body whose
// axes are principal, in the pose that gives the principal axes the same directions.
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <cmath>

#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::t_wrench;

/// The body alone, on a transparent background.
scene::Scene of_inertia(const Matrix3d& inertia, scene::Equimomental form) {
  scene::Scene scene = t_wrench(200, 160);
  scene.body = {{}, inertia, {}, form};
  scene.look.transparent = true;
  return scene;
}

/// The share of the pixels whose coverage differs by more than a tenth.
double mean_of_differences(const image::Image& a, const image::Image& b) {
  constexpr int tenth = 26;
  int differing = 0;
  for (std::size_t i = 3; i < a.pixels.size(); i += 4) {
    differing += std::abs(a.pixels[i] - b.pixels[i]) > tenth ? 1 : 0;
  }
  return 4.0 * differing / static_cast<double>(a.pixels.size());
}

TEST(InertiaMatrix, IsDrawnAlongItsPrincipalAxes) {
  const auto context = gl::make_test_context();
  const Matrix3d moments = Vector3d(3, 5, 7).asDiagonal();
  const Matrix3d X = so3::exp(Vector3d(-0.6, 0.5, 0.4));
  for (const auto form :
       {scene::Equimomental::box, scene::Equimomental::ellipsoid, scene::Equimomental::cross}) {
    const image::Image straight = PoseRenderer(*context, of_inertia(moments, form)).draw(X);
    for (const Vector3d& turn : {Vector3d(0.4, -0.8, 1.3), Vector3d(-2, 0.3, 0.1)}) {
      const Matrix3d R = so3::exp(turn), product = R * moments * R.transpose();
      PoseRenderer turned(*context, of_inertia((product + product.transpose()) / 2, form));
      EXPECT_LT(mean_of_differences(turned.draw(X * R.transpose()), straight), 1e-3)
          << static_cast<int>(form);
      EXPECT_GT(mean_of_differences(turned.draw(X), straight), 0.01) << "the axes of the body";
      EXPECT_GT(mean_of_differences(turned.draw(X * R), straight), 0.01) << "the inverse";
    }
  }
}

}  // namespace
}  // namespace twrench::draw
