#include "picture/body/lumps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "picture/body/meshes.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

TEST(Lumps, OfARingFollowIt) {
  const Eigen::Matrix3d turn = body::frame_with_z_along({1, 2, 2});
  const Vector3d centre(3, -1, 2);
  const std::vector<Capsule> capsules = lumps({body::Torus{5, 0.8}, 1, centre, turn});
  EXPECT_GE(capsules.size(), 6U);
  for (const Capsule& capsule : capsules) {
    EXPECT_NEAR(capsule.radius, 0.9, 0.3);
    const Vector3d middle = turn.transpose() * ((capsule.from + capsule.to) / 2 - centre);
    EXPECT_NEAR(std::hypot(middle.x(), middle.y()), 4.8, 0.4) << "on it, not across its hole";
    EXPECT_NEAR(middle.z(), 0, 0.3);
  }
}

TEST(Lumps, LieInsideASolidMesh) {
  for (const Capsule& capsule : lumps(part_of(ball_of_triangles(2, 24)))) {
    for (const Vector3d& end : {capsule.from, capsule.to}) {
      EXPECT_LT(end.norm() + capsule.radius, 2.4);
    }
  }
}

TEST(Lumps, OfAPlateAreMarked) {
  const auto slab = [](double z) {
    return lumps(part_of(
        {{{0, 0, 0}, {3, 0, 0}, {3, 6, 0}, {0, 6, 0}, {0, 0, z}, {3, 0, z}, {3, 6, z}, {0, 6, z}},
         {{0, 2, 1},
          {0, 3, 2},
          {4, 5, 6},
          {4, 6, 7},
          {0, 1, 5},
          {0, 5, 4},
          {1, 2, 6},
          {1, 6, 5},
          {2, 3, 7},
          {2, 7, 6},
          {3, 0, 4},
          {3, 4, 7}},
         {}}));
  };
  EXPECT_TRUE(std::ranges::all_of(slab(0.2), &Capsule::is_of_plate));
  EXPECT_TRUE(std::ranges::none_of(slab(3), &Capsule::is_of_plate));
}

TEST(Lumps, OfATriangleAreThere) {
  const std::vector<Capsule> capsules =
      lumps(part_of({{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}}, 0.1));
  ASSERT_FALSE(capsules.empty());
  for (const Capsule& capsule : capsules) EXPECT_TRUE(std::isfinite(capsule.from.norm()));
}

}  // namespace
}  // namespace twrench::picture
