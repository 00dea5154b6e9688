#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/enumeration.h"
#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::t_wrench;

Matrix3d turned(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

const std::uint8_t* pixel(const image::Image& image, int x, int y) {
  return &image.pixels[static_cast<std::size_t>(y) * image.row_bytes() +
                       static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels)];
}

/// Returns the alpha of a transparent frame at `point` in space.
int coverage_at(const PoseRenderer& renderer, const image::Image& image, const Vector3d& point) {
  const Eigen::Vector4d clip =
      renderer.camera().projection * renderer.camera().view * point.homogeneous();
  const double x = (0.5 + 0.5 * clip.x() / clip.w()) * image.width;
  const double y = (0.5 - 0.5 * clip.y() / clip.w()) * image.height;
  return pixel(image, static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)))[3];
}

double mean_difference(const image::Image& a, const image::Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
  return sum / static_cast<double>(a.pixels.size());
}

class RendererTest : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();

  static scene::Scene transparent(int width = 320, int height = 180) {
    scene::Scene scene = t_wrench(width, height);
    scene.look.transparent = true;
    return scene;
  }
};

TEST_F(RendererTest, DrawsOnTheBackgroundInTheFilmsSize) {
  scene::Scene scene = t_wrench(160, 90);
  scene.look.background = Color{0, 255, 0};
  const image::Image image = PoseRenderer(*context, scene).draw(Matrix3d::Identity());
  ASSERT_EQ(image.width, 160);
  ASSERT_EQ(image.height, 90);
  ASSERT_EQ(image.channels, 3);
  EXPECT_EQ(pixel(image, 0, 0)[1], 255);
  EXPECT_EQ(pixel(image, 159, 89)[1], 255);
  EXPECT_GT(pixel(image, 80, 45)[0], 20) << "metal, not green, in the middle";
}

TEST_F(RendererTest, DrawsNothingOfABodyBesideThePicture) {
  scene::Scene scene = transparent();
  const body::Ellipsoid ball{Vector3d::Constant(0.5)};
  scene.body.parts = {{ball, 1, {-20, 0, 0}, Matrix3d::Identity()},
                      {ball, 1, {20, 0, 0}, Matrix3d::Identity()}};
  scene.camera.distance = 0.2;
  for (const int samples : {1, 4}) {
    scene.look.samples = samples;
    const image::Image image = PoseRenderer(*context, scene).draw(Matrix3d::Identity());
    EXPECT_EQ(std::ranges::count(image.pixels, 0), 320 * 180 * 4);
  }
}

TEST_F(RendererTest, DrawsBodyPointsWhereItsMatricesMapThem) {
  PoseRenderer renderer(*context, transparent());
  for (int i = 0; i < 12; ++i) {
    const Matrix3d X = turned(0.4 * i + 0.1, {1.0, 0.3 * i, -0.5});
    const image::Image image = renderer.draw(X);
    for (const double y : {-3.9, 0.0, 3.9}) {
      // The handle's axis.
      EXPECT_EQ(coverage_at(renderer, image, X * Vector3d(-1, y, 0)), 255) << i;
    }
    EXPECT_EQ(coverage_at(renderer, image, X * Vector3d(3.9, 0, 0)), 255) << i;  // the leg's axis
  }
}

TEST_F(RendererTest, LeavesWhatIsBesideTheBodyClear) {
  scene::Scene scene = transparent();
  scene.camera.elevation = 0;
  PoseRenderer renderer(*context, scene);
  const image::Image image = renderer.draw(Matrix3d::Identity());
  for (const Vector3d& beside :
       {Vector3d(-2.2, 0, 0), Vector3d(0.4, 1.4, 0), Vector3d(0.4, -1.4, 0), Vector3d(4.3, 0, 0),
        Vector3d(-1, 4.3, 0)}) {
    EXPECT_EQ(coverage_at(renderer, image, beside), 0) << beside.transpose();
  }
}

TEST_F(RendererTest, ShowsNoGapWhereTheLegMeetsTheHandle) {
  // Seen along the handle, whose side curves away from the leg's flat end at x = 0.
  scene::Scene scene = transparent();
  scene.camera.elevation = std::numbers::pi / 2;
  PoseRenderer renderer(*context, scene);
  const image::Image image = renderer.draw(Matrix3d::Identity());
  for (const double z : {-0.93, -0.8, 0.8, 0.93}) {
    EXPECT_EQ(coverage_at(renderer, image, Vector3d(-0.1, 0, z)), 255) << z;
  }
}

TEST_F(RendererTest, DistinguishesAPoseFromItsTranspose) {
  PoseRenderer renderer(*context, t_wrench());
  const Matrix3d X = turned(0.8, {1, 2, 3});
  EXPECT_GT(mean_difference(renderer.draw(X), renderer.draw(X.transpose())), 3);
}

TEST_F(RendererTest, TurnsTheBodyAndNotTheLight) {
  // A T of two bars looks the same after half a turn about its leg.
  scene::Scene scene = t_wrench();
  scene.body.parts = {{body::Box{{2, 8, 2}}, 1, {-1, 0, 0}, Matrix3d::Identity()},
                      {body::Box{{4, 2, 2}}, 1, {2, 0, 0}, Matrix3d::Identity()}};
  PoseRenderer renderer(*context, scene);
  const Matrix3d X = turned(0.4, {1, 2, 3});
  const image::Image still = renderer.draw(X);
  EXPECT_LT(mean_difference(still, renderer.draw(X * turned(std::numbers::pi, {1, 0, 0}))), 0.25);
  EXPECT_GT(mean_difference(still, renderer.draw(turned(1.1, {0, 1, 0}) * X)), 2);
}

TEST_F(RendererTest, GivesStraightAlphaWithoutADarkFringe) {
  const image::Image image = PoseRenderer(*context, transparent()).draw(turned(0.5, {1, 1, 0}));
  int partial = 0;
  int darkest_inside = 255;
  int darkest_edge = 255;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const int alpha = image.pixels[i + 3];
    if (alpha == 255) darkest_inside = std::min<int>(darkest_inside, image.pixels[i]);
    if (alpha == 0 || alpha == 255) continue;
    if (alpha < 16) continue;  // too few levels to determine the colour
    ++partial;
    darkest_edge = std::min<int>(darkest_edge, image.pixels[i]);
  }
  EXPECT_GT(partial, 200);
  EXPECT_GT(darkest_edge, darkest_inside / 2);
}

TEST_F(RendererTest, LaysTheTransparentFrameOnTheBackgroundItDrawsItself) {
  scene::Scene scene = t_wrench(320, 180);
  scene.look.background = Color{255, 255, 255};
  const Matrix3d X = turned(0.5, {1, 1, 0});
  const image::Image opaque = PoseRenderer(*context, scene).draw(X);
  const image::Image clear = PoseRenderer(*context, transparent()).draw(X);
  for (std::size_t i = 0, j = 0; i < clear.pixels.size(); i += 4, j += 3) {
    const double alpha = clear.pixels[i + 3] / 255.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double expected = alpha * clear.pixels[i + c] + (1 - alpha) * 255;
      ASSERT_NEAR(opaque.pixels[j + c], expected, 1.5);
    }
  }
}

TEST_F(RendererTest, GivesTheSameBytesWhateverWasDrawnBefore) {
  const Matrix3d X = turned(0.8, {1, 2, 3});
  PoseRenderer first(*context, t_wrench());
  const image::Image alone = first.draw(X);
  for (int i = 0; i < 5; ++i) first.draw(turned(0.9 * i, {3, 1, 2}));
  EXPECT_EQ(first.draw(X).pixels, alone.pixels);
  PoseRenderer second(*context, t_wrench());
  EXPECT_EQ(second.draw(X).pixels, alone.pixels);
  EXPECT_EQ(first.draw(X).pixels, alone.pixels);
}

TEST_F(RendererTest, DrawsAPoseThatHasLeftTheRotations) {
  // Eq. (24) produces such poses: the body has grown beyond the frame, and beyond the camera too.
  PoseRenderer renderer(*context, transparent());
  const image::Image large = renderer.draw(1.5 * turned(0.5, {1, 1, 0}));
  EXPECT_EQ(coverage_at(renderer, large, Vector3d::Zero()), 255);
  EXPECT_NO_THROW(renderer.draw(10 * turned(0.5, {1, 1, 0})));
}

TEST_F(RendererTest, DrawsPicturesOfAnyShape) {
  scene::Scene scene = t_wrench();
  using enum scene::Feature;
  scene.overlay.show = {axes,   momentum, omega, trail,      plane, labels, floor,
                        sphere, poinsot,  hud,   components, curve, method, drift};
  scene.title = "The Dzhanibekov effect";
  scene.motion.duration = 1;
  for (const auto& [width, height] : {std::pair(16, 16),
                                      {100, 16},
                                      {16, 100},
                                      {1600, 16},
                                      {16, 1600},
                                      {728, 90},
                                      {90, 728},
                                      {996, 100},
                                      {1200, 200},
                                      {64, 64}}) {
    scene.film.width = width;
    scene.film.height = height;
    for (const scene::View view : enumerators<scene::View>) {
      scene.overlay.view = view;
      const timeline::Timeline timeline(scene, {0});
      Renderer renderer(*context, scene, timeline.solutions());
      const image::Frame frame = renderer.draw(timeline.frame_state(0));
      EXPECT_EQ(frame.image.width, width);
      EXPECT_EQ(frame.image.height, height);
      for (const image::Area& area : frame.damage) {
        EXPECT_EQ(image::common(area, {0, 0, width, height}), area) << width << "x" << height;
      }
    }
  }
}

TEST_F(RendererTest, FollowsTheLook) {
  const Matrix3d X = turned(0.5, {1, 1, 0});
  const image::Image plain = PoseRenderer(*context, t_wrench()).draw(X);
  const auto difference = [&](auto change) {
    scene::Scene scene = t_wrench();
    change(scene);
    return mean_difference(plain, PoseRenderer(*context, scene).draw(X));
  };
  EXPECT_EQ(difference([](scene::Scene&) {}), 0);
  EXPECT_GT(difference([](scene::Scene& s) { s.look.color = Color{255, 120, 40}; }), 1);
  EXPECT_GT(difference([](scene::Scene& s) { s.look.metallic = 0; }), 1);
  EXPECT_GT(difference([](scene::Scene& s) { s.look.roughness = 0.1; }), 0.5);
  EXPECT_GT(difference([](scene::Scene& s) { s.camera.azimuth = 0.25; }), 1);
  EXPECT_GT(difference([](scene::Scene& s) { s.camera.field_of_view = 1.2; }), 0.3);
  EXPECT_GT(difference([](scene::Scene& s) { s.look.samples = 4; }), 0.02);
}

}  // namespace
}  // namespace twrench::draw
