#include "picture/hud/moments_panel.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <array>
#include <optional>

#include "picture/overlay_scene.h"

namespace twrench::picture {
namespace {

std::vector<Layer> moments_of(const Eigen::Vector3d& omega, const OverlayColors*& colors,
                              const std::optional<Eigen::Matrix3d>& inertia = {}) {
  scene::Scene scene = film_of(1280, 720);
  scene.overlay.show.insert(scene::Feature::moments);
  scene.motion.omega = omega;
  if (inertia) scene.body = {{}, inertia};
  const OverlayScene all(scene);
  colors = &style_of(scene.look.theme).overlay;
  MomentsPanel panel(all.scene, all.timeline.solutions(), all.layout, all.typeface, all.colors);
  return panel.draw(all.timeline.frame_state(0));
}

/// Returns the number of rows with pixels of exactly this colour.
int height_of(const Layer& layer, const Color& color) {
  int rows = 0;
  for (int y = 0; y < layer.image.height; ++y) {
    int count = 0;
    for (int x = 0; x < layer.image.width; ++x) {
      const std::uint8_t* p =
          &layer.image.pixels[static_cast<std::size_t>(y) * layer.image.row_bytes() +
                              static_cast<std::size_t>(4 * x)];
      count += p[0] == color.red && p[1] == color.green && p[2] == color.blue ? 1 : 0;
    }
    rows += count > 20 ? 1 : 0;  // a bar, not a letter
  }
  return rows;
}

TEST(MomentsPanel, HasBarsInProportionAndMarksTheAxisOfTheRotation) {
  const OverlayColors* colors = nullptr;
  const auto about_x = moments_of({1, 0, 0}, colors), about_z = moments_of({0, 0, 1}, colors);
  ASSERT_EQ(about_x.size(), 1U);
  const int x = height_of(about_x[0], colors->axis[0]), z = height_of(about_z[0], colors->axis[2]);
  EXPECT_NEAR(static_cast<double>(x) / z, 982.27 / 1578.65, 0.02);
  EXPECT_EQ(height_of(about_x[0], colors->axis[2]), 0) << "faint";
  EXPECT_EQ(height_of(about_z[0], colors->axis[0]), 0) << "faint";
}

// I1 and I2 of this body are both nearest to x.
TEST(MomentsPanel, GivesEachPrincipalAxisAColourOfItsOwn) {
  const Eigen::Matrix3d R = so3::exp(Eigen::Vector3d(-0.72, -0.32, -0.74));
  const Eigen::Matrix3d product = R * Eigen::Vector3d(2, 3, 4).asDiagonal() * R.transpose();
  const Eigen::Matrix3d inertia = (product + product.transpose()) / 2;
  const OverlayColors* colors = nullptr;
  std::array<double, 3> heights{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto about = moments_of(R.col(axis), colors, inertia);
    heights.at(static_cast<std::size_t>(axis)) =
        height_of(about[0], colors->axis[static_cast<std::size_t>(axis)]);
  }
  EXPECT_NEAR(heights[0] / heights[2], 2.0 / 4, 0.02);
  EXPECT_NEAR(heights[1] / heights[2], 3.0 / 4, 0.02);
}

TEST(MomentsPanel, MarksNoAxisOfABodyAtRest) {
  const OverlayColors* colors = nullptr;
  const auto rest = moments_of({0, 0, 0}, colors);
  for (const Color& color : colors->axis) EXPECT_EQ(height_of(rest[0], color), 0);
}

}  // namespace
}  // namespace twrench::picture
