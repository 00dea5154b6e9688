#include <gtest/gtest.h>

#include <random>

#include "mesh/overlaps.h"
#include "mesh/samples.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;

TEST(WindingNumber, IsOneInsideAndZeroOutside) {
  for (const Vector3d& at : {Vector3d(0, 0, 0), Vector3d(1e4, -3e4, 2e4)}) {
    const body::TriangleMesh ball = moved(ball_with_open_poles(96, 48, 0), at);
    const TriangleTree tree(ball);
    Allowance allowance(usual_steps);
    std::mt19937 random(2);
    for (int i = 0; i < 2000; ++i) {
      const auto part = [&] { return 3 * (static_cast<double>(random()) * 0x1p-32 - 0.5); };
      const Vector3d point(part(), part(), part());
      if (std::abs(point.norm() - 1) < 0.01) continue;
      EXPECT_EQ(winding_number(
                    tree, at + point, [](std::uint32_t) { return true; }, allowance),
                point.norm() < 1 ? 1 : 0)
          << point.transpose();
    }
  }
}

TEST(WindingNumber, CountsSurfacesOneByOne) {
  const body::TriangleMesh mesh =
      joined(joined(cube({0, 0, 0}, 3), cube({1, 1, 1}, 1)), turned(cube({0.5, 0.5, 0.5}, 2)));
  const TriangleTree tree(mesh);
  Allowance allowance(usual_steps);
  const auto all = [](std::uint32_t) { return true; };
  EXPECT_EQ(winding_number(tree, {1.5, 1.5, 1.5}, all, allowance), 1);
  EXPECT_EQ(winding_number(tree, {0.75, 0.75, 0.75}, all, allowance), 0);
  EXPECT_EQ(winding_number(tree, {0.25, 0.25, 0.25}, all, allowance), 1);
  EXPECT_EQ(winding_number(
                tree, {1.5, 1.5, 1.5}, [](std::uint32_t t) { return t < 24; }, allowance),
            2);
  EXPECT_EQ(winding_number(
                tree, {1.5, 1.5, 1.5}, [](std::uint32_t t) { return t >= 24; }, allowance),
            -1);
}

TEST(WindingNumber, IsNothingOnTheSurface) {
  const body::TriangleMesh mesh = cube({0, 0, 0}, 1);
  const TriangleTree tree(mesh);
  Allowance allowance(usual_steps);
  const auto all = [](std::uint32_t) { return true; };
  for (const Vector3d& point :
       {Vector3d(0.3, 0.4, 0), Vector3d(0.5, 0.5, 1), Vector3d(0, 0, 0), Vector3d(1, 0.3, 1)}) {
    EXPECT_FALSE(winding_number(tree, point, all, allowance)) << point.transpose();
  }
}

}  // namespace
}  // namespace twrench::mesh
