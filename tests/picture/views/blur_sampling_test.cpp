#include "picture/views/blur_sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<int> exposure(int count, int total) {
  std::vector<int> chosen;
  for (int i = 0; i < total; ++i) {
    if (is_in_exposure(i, count, total)) chosen.push_back(i);
  }
  return chosen;
}

TEST(Exposure, ConsistsOfPosesThatAreEvenlySpreadAboutItsMiddle) {
  for (int total = 1; total <= 40; ++total) {
    for (int count = 1; count <= total; ++count) {
      if (total % 2 == 0 && count % 2 == 1) continue;  // none in the middle
      const std::vector<int> chosen = exposure(count, total);
      ASSERT_EQ(chosen.size(), static_cast<std::size_t>(count)) << total;
      const int sum = std::accumulate(chosen.begin(), chosen.end(), 0);
      ASSERT_EQ(2 * sum, count * (total - 1)) << count << " of " << total;
      for (int i = 1; i < count; ++i) {
        const int gap =
            chosen[static_cast<std::size_t>(i)] - chosen[static_cast<std::size_t>(i - 1)];
        ASSERT_LT(std::abs(gap - double(total) / count), 1.5) << count << " of " << total;
      }
    }
  }
}

/// A rod along x, 8 cm long, before a camera on z.
class BlurOfARod : public testing::Test {
 protected:
  std::vector<body::Part> parts{
      {body::Cylinder{1, 8}, 1, Vector3d::Zero(), body::frame_with_z_along(Vector3d::UnitX())}};
  double radius = std::hypot(4, 1);
  image::Area pane{0, 0, 640, 640};
  Camera camera = frame_sphere({Vector3d::UnitZ(), 0.5, 1, radius});
  // Its middle, its end, and a corner of the picture.
  std::vector<image::Area> areas{{310, 310, 20, 20}, {560, 310, 20, 20}, {0, 0, 20, 20}};

  std::vector<int> counts(double angle, int total, const Vector3d& axis = Vector3d::UnitZ()) const {
    std::vector<Matrix3d> poses;
    for (int i = 0; i < total; ++i) {
      poses.emplace_back(Eigen::AngleAxisd(angle * (i + 0.5) / total - angle / 2, axis));
    }
    return BlurSampling(parts, body_mesh(parts, 0.01), radius).counts(areas, camera, pane, poses);
  }
};

TEST_F(BlurOfARod, CallsForFewPosesNearItsAxisAndForOneWhereItIsNot) {
  const std::vector<int> all = counts(0.1, 16);
  EXPECT_LE(all[0], 6);
  EXPECT_GE(all[1], 12);
  EXPECT_EQ(all[2], 1);
}

// Poses at the end of the rod are no farther apart than those at the edge of the picture.
TEST_F(BlurOfARod, KeepsPosesAsCloseTogetherAsAtTheEdge) {
  for (const double angle : {0.02, 0.08, 0.2}) {
    for (const int total : {5, 8, 20}) {
      const double end =
          (pixel_of(camera, pane, {4, 0, 0}) - pixel_of(camera, pane, {0, 0, 0})).norm();
      EXPECT_GE(counts(angle, total)[1], std::floor(total * end / 320)) << angle << " " << total;
    }
  }
}

TEST_F(BlurOfARod, IsTheSameInAWidePicture) {
  const std::vector<int> square = counts(0.1, 16);
  pane.width *= 2;
  camera = frame_sphere({Vector3d::UnitZ(), 0.5, 2, radius});
  for (image::Area& area : areas) area.x += 320;
  EXPECT_EQ(counts(0.1, 16), square);
}

TEST_F(BlurOfARod, CallsForFewPosesWhereItMovesTowardsTheEye) {
  EXPECT_LE(counts(0.1, 16, Vector3d::UnitY())[1], 8);
}

TEST_F(BlurOfARod, LeavesOutNoPoseOfAWideTurn) {
  EXPECT_EQ(counts(1, 16), std::vector<int>(3, 16));
}

TEST_F(BlurOfARod, LeavesOutNoPoseOfSomethingThin) {
  parts[0].shape = body::Cylinder{0.02, 8};
  EXPECT_EQ(counts(0.1, 16), std::vector<int>(3, 16));
}

TEST_F(BlurOfARod, IsThatOfABodyAtRest) { EXPECT_EQ(counts(0, 8)[0], 2); }

}  // namespace
}  // namespace twrench::picture
