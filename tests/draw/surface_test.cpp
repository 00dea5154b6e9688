// Tests the surface of the body: it shows light and its rotation, without artefacts.
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "image/compare.h"
#include "picture/body/meshes.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::ball_of_triangles;
using picture::cylinder;
using picture::part_of;
using picture::pixel_of;
using picture::t_wrench;

class Surface : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();

  static scene::Scene transparent(std::vector<body::Part> parts, int width, int height) {
    scene::Scene scene = t_wrench(width, height);
    scene.body.parts = std::move(parts);
    scene.motion.omega.setZero();
    scene.look.transparent = true;
    return scene;
  }
};

/// Returns the darkest and the brightest channel mean of the pixels that the body covers.
std::pair<double, double> range(const image::Image& image) {
  double low = 255, high = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (image.pixels[i + 3] < 255) continue;
    const double mean = (image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2]) / 3.0;
    low = std::min(low, mean);
    high = std::max(high, mean);
  }
  return {low, high};
}

/// Returns the mean difference of the red channel over the pixels that both pictures cover.
double mean_change(const image::Image& a, const image::Image& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    if (a.pixels[i + 3] < 255 || b.pixels[i + 3] < 255) continue;
    sum += std::abs(a.pixels[i] - b.pixels[i]);
    ++count;
  }
  return sum / count;
}

// In frame 105 of the default film the leg points at the camera. The crease was once black there.
TEST_F(Surface, IsLitInTheCreaseByTheOtherPart) {
  scene::Scene scene = t_wrench(640, 360);
  scene.look.transparent = true;
  scene.overlay.show = {};
  const timeline::Timeline timeline(scene, {105});
  Renderer renderer(*context, scene, timeline.solutions());
  const auto [low, high] = range(renderer.draw(timeline.frame_state(0)).image);
  EXPECT_GT(low, 25);
  EXPECT_GT(high, 235) << "highlights are nearly white";
}

TEST_F(Surface, OfABrushedCylinderShowsThatItTurnsAboutItsAxis) {
  const auto change = [&](double metallic) {
    scene::Scene scene =
        transparent({cylinder(1, 4, {0, 0, 0}, Vector3d::UnitX()),
                     {body::Box{{0.2, 0.2, 0.2}}, 1, {0.7, 0.5, 0}, Matrix3d::Identity()}},
                    640, 360);
    scene.look.metallic = metallic;
    PoseRenderer renderer(*context, scene);
    const Vector3d axis = Vector3d::UnitX();
    return mean_change(renderer.draw(so3::exp(0.3 * axis)), renderer.draw(so3::exp(0.35 * axis)));
  };
  EXPECT_GT(change(1), 0.8);
  EXPECT_LT(change(0), 0.2) << "paint is not brushed";
}

TEST_F(Surface, OfABodyOfRevolutionIsMarked) {
  const body::Part ball{body::Ellipsoid{{1, 1, 1}}, 1, {0, 0, 0}, Matrix3d::Identity()};
  for (const body::Part& part : {ball, cylinder(1, 3, {0, 0, 0}, Vector3d::UnitY())}) {
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
      PoseRenderer renderer(*context, transparent({part}, 320, 180));
      const Matrix3d X = so3::exp(Vector3d(0.5, 0.4, 0.1));
      EXPECT_GT(mean_change(renderer.draw(X), renderer.draw(so3::exp(0.3 * axis) * X)), 3);
    }
  }
}

TEST_F(Surface, OfABoxShowsThatItHasTurnedOver) {
  const body::Part box{body::Box{{2, 3, 1}}, 1, {0, 0, 0}, Matrix3d::Identity()};
  PoseRenderer renderer(*context, transparent({box}, 320, 180));
  const Matrix3d X = so3::exp(Vector3d(0.5, 0.4, 0.1));
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
    const Matrix3d turned = X * so3::exp(std::numbers::pi * axis);
    EXPECT_GT(mean_change(renderer.draw(X), renderer.draw(turned)), 5) << axis.transpose();
  }
}

/// Returns the mean colour of the pixels that the body covers on one side of the picture.
Eigen::Vector3d mean_color(const image::Image& image, bool on_the_left) {
  Eigen::Vector3d sum = Vector3d::Zero();
  double count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const bool is_left = static_cast<int>(i / 4) % image.width < image.width / 2;
    if (image.pixels[i + 3] < 255 || is_left != on_the_left) continue;
    sum += Vector3d(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    ++count;
  }
  return sum / count;
}

// Expects red on the left and blue on the right.
void expect_two_colors(const image::Image& image) {
  const Vector3d left = mean_color(image, true), right = mean_color(image, false);
  EXPECT_GT(left[0], 2 * left[2]);
  EXPECT_GT(right[2], 2 * right[0]);
}

TEST_F(Surface, HasTheColourOfEachPart) {
  scene::Scene scene = transparent(
      {cylinder(1, 2, {-2, 0, 0}, Vector3d::UnitX()), cylinder(1, 2, {2, 0, 0}, Vector3d::UnitX())},
      320, 180);
  scene.look.metallic = 0;
  scene.body.descriptions.resize(2);
  scene.body.descriptions[0].look.color = Color{220, 20, 20};
  scene.body.descriptions[1].look.color = Color{20, 20, 220};
  for (const int samples : {1, 4}) {
    scene.look.samples = samples;
    expect_two_colors(PoseRenderer(*context, scene).draw(Matrix3d::Identity()));
  }
}

TEST_F(Surface, HasTheColoursOfAMeshsVertices) {
  body::TriangleMesh ball = ball_of_triangles(1, 40);
  for (const Vector3d& vertex : ball.vertices) {
    ball.colors.push_back(vertex.x() < 0 ? std::array{0.9F, 0.1F, 0.1F}
                                         : std::array{0.1F, 0.1F, 0.9F});
  }
  for (const double metallic : {0.0, 1.0}) {
    scene::Scene scene = transparent({part_of(ball)}, 320, 180);
    scene.look.metallic = metallic;
    expect_two_colors(PoseRenderer(*context, scene).draw(Matrix3d::Identity()));
  }
}

// A mesh looks as good as the shape that it approximates.
TEST_F(Surface, OfAFineMeshLooksLikeTheShapes) {
  const body::Part box{body::Box{{0.4, 0.4, 0.4}}, 1, {1.5, 0, 0}, Matrix3d::Identity()};
  const body::Part ball{body::Ellipsoid{{1, 1, 1}}, 1, {0, 0, 0}, Matrix3d::Identity()};
  const auto drawn = [&](const body::Part& part) {
    return PoseRenderer(*context, transparent({part, box}, 320, 180)).draw(so3::exp({0.4, 0.3, 0}));
  };
  const image::Image exact = drawn(ball), mesh = drawn(part_of(ball_of_triangles(1, 90)));
  EXPECT_LT(mean_change(exact, mesh), 3);
  EXPECT_LT(image::compare(exact, mesh, 48)->share, 0.006) << "of 255: along the outline";
}

// The outline must not reveal how the facets of a sphere turn.
TEST_F(Surface, HasARoundOutlineThatStaysAsASphereTurns) {
  const body::Part ball{body::Ellipsoid{{1, 1, 1}}, 1, {0, 0, 0}, Matrix3d::Identity()};
  PoseRenderer renderer(*context, transparent({ball}, 640, 360));
  const image::Image still = renderer.draw(Matrix3d::Identity());
  for (const double angle : {0.01, 0.02, 0.5}) {
    const image::Image turned = renderer.draw(so3::exp(angle * Vector3d(1, 2, 2) / 3));
    int worst = 0;
    for (std::size_t i = 3; i < still.pixels.size(); i += 4) {
      worst = std::max(worst, std::abs(still.pixels[i] - turned.pixels[i]));
    }
    EXPECT_LE(worst, 40) << "of 255, in coverage";
  }
}

/// Returns by how much a place along the rim of the handle's lower cap may outshine both places a
/// few pixels beside it, at most. The value of a place is its brightest pixel across the rim.
int brightest_bead(const PoseRenderer& renderer, const image::Image& image, const Matrix3d& X) {
  const std::size_t count = static_cast<std::size_t>(image.width) / 5;
  std::vector<int> rim;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const Vector3d place = X * Vector3d(std::cos(angle) - 1, -4, std::sin(angle));
    const Eigen::Vector2i pixel =
        pixel_of(renderer.camera(), {0, 0, image.width, image.height}, place).cast<int>();
    int most = 0;
    for (int k = 0; k < 25; ++k) {
      const int row = pixel.y() + k / 5 - 2, column = pixel.x() + k % 5 - 2;
      const auto* const p =
          &image.pixels[static_cast<std::size_t>(4 * (row * image.width + column))];
      if (p[3] == 255) most = std::max<int>(most, p[0]);
    }
    rim.push_back(most);
  }
  int brightest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int beside = std::max(rim[(i + count - 4) % count], rim[(i + 4) % count]);
    brightest = std::max(brightest, rim[i] - beside);
  }
  return brightest;
}

// With one sample per pixel, a bevel narrower than a pixel must not glitter; it would by hundreds.
// With four samples there are no beads. The remaining difference, up to 30, is at the ends of
// highlights, which are more abrupt with one sample.
TEST_F(Surface, HasNoBeadsAlongTheRimOfACap) {
  for (const int width : {640, 1280}) {
    scene::Scene scene = transparent(t_wrench().body.parts, width, width * 9 / 16);
    PoseRenderer one(*context, scene);
    scene.look.samples = 4;
    PoseRenderer four(*context, scene);
    for (const double turn : {0.0, 0.4, 0.8, 1.2, 1.6}) {
      const Matrix3d X = so3::exp(Vector3d(-0.7, 0, 0)) * so3::exp(Vector3d(0, turn, 0));
      EXPECT_LE(brightest_bead(one, one.draw(X), X), brightest_bead(four, four.draw(X), X) + 32)
          << width << " pixels wide, turned by " << turn;
    }
  }
}

// The rim of a cap that faces away is the outline of the side, and most of it appears narrower than
// a pixel. It then shows the side, which is nearly as dark there as beside it.
TEST_F(Surface, HasNoDotsAlongTheRimOfACapThatFacesAway) {
  for (const int width : {640, 1280}) {
    PoseRenderer renderer(*context, transparent(t_wrench().body.parts, width, width * 9 / 16));
    for (const double tilt : {0.3, 0.6}) {
      for (const double turn : {0.0, 0.4, 1.2}) {
        const Matrix3d X = so3::exp(Vector3d(tilt, 0, 0)) * so3::exp(Vector3d(0, turn, 0));
        EXPECT_LE(brightest_bead(renderer, renderer.draw(X), X), 6)
            << width << " pixels wide, tilted by " << tilt << ", turned by " << turn;
      }
    }
  }
}

const body::Part tube{body::Tube{2, 1.5, 3}, 1, {0, 0, 0}, Matrix3d::Identity()};
const body::Part torus{body::Torus{2, 0.7}, 1, {0, 0, 0}, Matrix3d::Identity()};

/// Returns how many pixels differ by more than 12 of 255 and have few others that do so within 15 x
/// 15 pixels.
int specks(const image::Image& a, const image::Image& b) {
  const auto differs = [&](int row, int column) {
    const auto at = static_cast<std::size_t>(4 * (row * a.width + column));
    return std::abs(a.pixels[at] - b.pixels[at]) > 12;
  };
  constexpr int side = 15, few = 12;
  int count = 0;
  for (int row = side; row + side < a.height; ++row) {
    for (int column = side; column + side < a.width; ++column) {
      if (!differs(row, column)) continue;
      int near = 0;
      for (int k = 0; k < side * side; ++k) {
        near += differs(row + k / side - side / 2, column + k % side - side / 2) ? 1 : 0;
      }
      if (near < few) ++count;
    }
  }
  return count;
}

// Half a turn about the axis only swaps the white and the black end of the stripe. Paint must not
// appear beside the stripe where facets are seen edge-on. The remaining differences are at the
// stripe's own ends, where it becomes narrower than a pixel.
TEST_F(Surface, HasNoSpecksOfTheMarkAlongOutlines) {
  for (const body::Part& part : {torus, tube}) {
    scene::Scene scene = transparent({part}, 640, 360);
    scene.look.metallic = 0;
    for (const int samples : {1, 4}) {
      scene.look.samples = samples;
      PoseRenderer renderer(*context, scene);
      int count = 0;
      for (const double tilt : {0.9, 1.3, 1.5}) {
        for (const double angle : {0.2, 0.6, 1.2}) {
          const Matrix3d X = so3::exp(Vector3d(0.2, tilt, 0.3)) * so3::exp(Vector3d(0, 0, angle));
          const Matrix3d turned = X * so3::exp(Vector3d(0, 0, std::numbers::pi));
          count += specks(renderer.draw(X), renderer.draw(turned));
        }
      }
      EXPECT_LE(count, std::holds_alternative<body::Torus>(part.shape) ? 36 : 12) << samples;
    }
  }
}

// With one sample per pixel, the rim is moved half a pixel inwards. The end face beside it is flat
// and reflects the same as with four samples, and so does a rim that appears narrower than a pixel.
TEST_F(Surface, HasEndFacesThatReflectTheSameUpToTheRim) {
  scene::Scene scene = transparent({tube}, 640, 360);
  PoseRenderer one(*context, scene);
  scene.look.samples = 4;
  PoseRenderer four(*context, scene);
  for (const double tilt : {-1.4, -1.35, -1.3}) {
    const Matrix3d X = so3::exp(Vector3d(tilt, 0, 0)) * so3::exp(Vector3d(0, 0, 0.8));
    EXPECT_LT(mean_change(one.draw(X), four.draw(X)), 1) << "of 255, tilted by " << tilt;
  }
}

}  // namespace
}  // namespace twrench::draw
