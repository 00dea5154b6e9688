// Frames compared with images that were inspected and found correct. To change an image, run
// TWRENCH_UPDATE_GOLDENS=1 golden_test, inspect the new image, and commit it with the reason.
#include "picture/golden.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <algorithm>

#include "base/enumeration.h"
#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "image/png.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::alike;
using picture::cylinder;
using picture::expect_golden;
using picture::golden_path;
using picture::t_wrench;

struct Golden {
  const char* name;
  scene::Scene scene;
  Matrix3d X;
  std::set<scene::Feature> features = {};
};

void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.name; }

scene::Scene with_parts(std::vector<body::Part> parts) {
  scene::Scene scene = t_wrench(320, 180);
  scene.body.parts = std::move(parts);
  return scene;
}

scene::Scene mixed_body() {
  return with_parts({cylinder(0.6, 6, {0, 0, 0}, Vector3d(1, 0.4, 0)),
                     {body::Box{{1, 3, 2}}, 3, {3, 1, 0}, so3::exp(Vector3d(0.3, 0.2, 0.1))},
                     {body::Ellipsoid{{1.5, 1, 0.8}}, 5, {-3, -1, 0.5}, Matrix3d::Identity()}});
}

scene::Scene with_theme(scene::Theme theme) {
  scene::Scene scene = t_wrench(320, 180);
  scene.look.theme = theme;
  return scene;
}

std::vector<Golden> golden_scenes() {
  scene::Scene transparent = t_wrench(240, 240);
  transparent.look.transparent = true;
  scene::Scene painted = t_wrench(320, 180);
  painted.look.background = Color{250, 250, 245};
  painted.look.color = Color{190, 60, 40};
  painted.look.metallic = 0;
  painted.look.roughness = 0.6;
  scene::Scene moments = t_wrench(320, 180);
  moments.body = {{}, Vector3d(3, 5, 7).asDiagonal()};
  scene::Scene blurred = t_wrench(320, 180);
  blurred.look.motion_blur = 6;
  const Matrix3d Id = Matrix3d::Identity();
  const Matrix3d tumbling = so3::exp(Vector3d(0.7, -0.9, 0.4));
  return {
      {"wrench", t_wrench(320, 180), Id},
      {"wrench-tumbling", t_wrench(320, 180), so3::exp(Vector3d(0.7, -0.9, 0.4))},
      {"wrench-leg-to-camera", t_wrench(320, 180), so3::exp(Vector3d(0.2, -1.45, 0.1))},
      {"wrench-over", t_wrench(320, 180), so3::exp(Vector3d(2.5, 0.3, 1.2))},
      {"wrench-portrait", t_wrench(180, 320), so3::exp(Vector3d(-0.5, 0.6, 0.9))},
      {"wrench-wide", t_wrench(420, 180), so3::exp(Vector3d(0.3, 2.4, -0.6))},
      {"wrench-transparent", transparent, so3::exp(Vector3d(1.1, 0.5, -0.3))},
      {"wrench-painted", painted, so3::exp(Vector3d(0.7, -0.9, 0.4))},
      {"box", with_parts({{body::Box{{2, 3, 4}}, 1, {0, 0, 0}, Id}}),
       so3::exp(Vector3d(0.5, 0.8, 0.2))},
      {"ellipsoid", with_parts({{body::Ellipsoid{{1, 2, 3}}, 1, {0, 0, 0}, Id}}),
       so3::exp(Vector3d(0.9, 0.7, 0.3))},
      {"mixed", mixed_body(), so3::exp(Vector3d(0.4, 0.6, -0.2))},
      {"floor", with_theme(scene::Theme::studio), tumbling, {scene::Feature::floor}},
      {"paper", with_theme(scene::Theme::paper), tumbling, {scene::Feature::floor}},
      {"space", with_theme(scene::Theme::space), tumbling, {scene::Feature::floor}},
      {"motion-blur", blurred, tumbling},
      {"moments-alone", moments, so3::exp(Vector3d(-0.6, 0.5, 0.4))},
  };
}

image::Image drawn(const Golden& golden, const Matrix3d& X) {
  const auto context = gl::make_test_context();
  return PoseRenderer(*context, golden.scene, golden.features).draw(X);
}

class GoldenImage : public testing::TestWithParam<Golden> {};

TEST_P(GoldenImage, IsDrawn) { expect_golden(GetParam().name, drawn(GetParam(), GetParam().X)); }

// The thresholds must detect this.
TEST_P(GoldenImage, SeesAWrongPose) {
  const image::Image golden = image::read_png(golden_path(GetParam().name));
  const Matrix3d& X = GetParam().X;
  constexpr double half_a_degree = 0.0087266;
  double least_mean = 255;
  for (int axis = 0; axis < 3; ++axis) {
    const image::Image turned =
        drawn(GetParam(), so3::exp(half_a_degree * Vector3d::Unit(axis)) * X);
    EXPECT_FALSE(alike(turned, golden)) << "half a degree about " << axis;
    least_mean = std::min(least_mean, image::compare(turned, golden, 0)->mean);
  }
  RecordProperty("least_mean", fmt::format("{:.4f}", least_mean));
  if (!X.isIdentity()) {
    EXPECT_FALSE(alike(drawn(GetParam(), X.transpose()), golden)) << "the transpose";
  }
  Matrix3d swapped = X;
  swapped.col(0) = X.col(1);
  swapped.col(1) = X.col(0);
  EXPECT_FALSE(alike(drawn(GetParam(), swapped), golden)) << "two axes swapped";
}

INSTANTIATE_TEST_SUITE_P(All, GoldenImage, testing::ValuesIn(golden_scenes()),
                         [](const auto& param) {
                           std::string name(param.param.name);
                           std::erase(name, '-');
                           return name;
                         });

TEST(GoldenImages, ShowEachTheme) {
  std::set<scene::Theme> shown;
  for (const Golden& golden : golden_scenes()) shown.insert(golden.scene.look.theme);
  for (const scene::Theme theme : enumerators<scene::Theme>) {
    EXPECT_TRUE(shown.contains(theme)) << enumerator_name(theme) << " has no golden image";
  }
}

}  // namespace
}  // namespace twrench::draw
