#include "draw/floor.h"

#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <cmath>
#include <memory>

#include "base/enumeration.h"
#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "picture/t_wrench.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using picture::cylinder;
using picture::t_wrench;

class FloorTest : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();

  image::Image drawn(const scene::Scene& scene, const Matrix3d& X,
                     const std::set<scene::Feature>& features) const {
    return PoseRenderer(*context, scene, features).draw(X);
  }

  /// Returns the effect of the floor: the red of each pixel with it, minus that without it.
  std::vector<int> change(const scene::Scene& scene, const Matrix3d& X) const {
    const image::Image with = drawn(scene, X, {scene::Feature::floor});
    const image::Image without = drawn(scene, X, {});
    std::vector<int> result;
    for (std::size_t i = 0; i < with.pixels.size(); i += 3) {
      result.push_back(with.pixels[i] - without.pixels[i]);
    }
    return result;
  }

  static scene::Scene white() {
    scene::Scene scene = t_wrench(320, 180);
    scene.look.background = Color{255, 255, 255};
    scene.camera.distance = 1.5;
    return scene;
  }

  /// Returns the centre of the shadow on a white floor: column and row.
  Eigen::Vector2d shadow(const scene::Scene& scene, const Matrix3d& X) const {
    const std::vector<int> darker = change(scene, X);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < darker.size(); ++i) {
      const double dark = std::min(darker[i], 0);
      sum += dark * Eigen::Vector2d(static_cast<double>(i % 320), static_cast<double>(i / 320));
      weight += dark;
    }
    return sum / weight;
  }
};

TEST_F(FloorTest, HasTheShadowOfABodyOfAnySize) {
  scene::Scene ball = white();
  ball.body.descriptions.clear();
  const auto sized = [&](double radius) {
    ball.body.parts = {
        {body::Ellipsoid{Vector3d::Constant(radius)}, 1, {0, 0, 0}, Matrix3d::Identity()}};
    return shadow(ball, Matrix3d::Identity());
  };
  const Eigen::Vector2d expected = sized(1);
  EXPECT_LT((sized(1e6) - expected).norm(), 0.5);
}

TEST_F(FloorTest, IsLightThatFadesBeforeAHorizon) {
  const scene::Scene scene = t_wrench(320, 180);
  const std::vector<int> light = change(scene, Matrix3d::Identity());
  const auto at = [&](int column, int row) {
    return light[static_cast<std::size_t>(320 * row + column)];
  };
  EXPECT_GT(*std::ranges::max_element(light), 15);
  EXPECT_GT(at(170, 178), at(100, 178) + 3) << "brightest below the body";
  for (int column = 0; column < 320; column += 20) EXPECT_LE(at(column, 10), 1) << column;
  for (int row = 1; row < 180; ++row) {
    EXPECT_LE(std::abs(at(40, row) - at(40, row - 1)), 2) << "no edge, row " << row;
  }
}

TEST_F(FloorTest, LeavesAFlatBackgroundItsColourAndShadesIt) {
  const scene::Scene scene = white();
  const std::vector<int> darker = change(scene, Matrix3d::Identity());
  EXPECT_EQ(darker.front(), 0);
  EXPECT_LT(*std::ranges::min_element(darker), -40);
}

TEST_F(FloorTest, HasAShadowBelowTheBodyThatMovesWithIt) {
  const scene::Scene scene = white();
  // The leg, which casts most of the shadow, points right or left.
  const Eigen::Vector2d right = shadow(scene, Matrix3d::Identity());
  const Eigen::Vector2d left = shadow(scene, so3::exp(Vector3d(0, 3.14, 0)));
  EXPECT_GT(right.x(), left.x() + 5);
  EXPECT_GT(left.y(), 110);
  // A small rotation moves it slightly: it neither jumps nor pulsates.
  const Eigen::Vector2d near = shadow(scene, so3::exp(Vector3d(0, 0.01, 0)));
  EXPECT_LT((near - right).norm(), 0.5);
}

// A film with a transparent background is laid over another picture. It must then look as if it had
// been drawn over it.
TEST_F(FloorTest, CanBeAShadowAloneInTheAlpha) {
  for (const scene::Theme theme : enumerators<scene::Theme>) {
    for (const double size : {1e-6, 1.0, 1e6}) {
      scene::Scene scene = white();
      scene.look.theme = theme;
      for (body::Part& part : scene.body.parts) {
        part.shape = body::Cylinder{0.5 * size, 8 * size};
        part.position *= size;
      }
      const Matrix3d X = so3::exp(Vector3d(0.1, 0.2, 0.3));
      const image::Image opaque = drawn(scene, X, {scene::Feature::shadow});
      scene.look.background.reset();
      scene.look.transparent = true;
      const image::Image alone = drawn(scene, X, {scene::Feature::shadow});
      int shaded = 0, worst = 0;
      for (std::size_t i = 0; i < alone.pixels.size() / 4; ++i) {
        const std::uint8_t* const p = &alone.pixels[4 * i];
        const double alpha = p[3] / 255.0;
        if (p[0] == 0 && p[3] > 0) ++shaded;
        const double over_white = alpha * p[0] + 255 * (1 - alpha);
        worst = std::max(worst, static_cast<int>(std::abs(over_white - opaque.pixels[3 * i])));
      }
      EXPECT_GT(shaded, 1000) << size;
      EXPECT_LE(worst, 3) << size;
    }
  }
}

TEST_F(FloorTest, FadesAwayWhereAnotherPaneAdjoins) {
  scene::Scene scene = white();
  scene.overlay.view = scene::View::quad;  // the body is in the upper left quarter
  scene.camera.distance = 1.0;
  const std::vector<int> darker = change(scene, Matrix3d::Identity());
  const auto at = [&](int column, int row) {
    return darker[static_cast<std::size_t>(320 * row + column)];
  };
  EXPECT_LT(*std::ranges::min_element(darker), -20);
  for (int column = 0; column < 160; ++column) EXPECT_GE(at(column, 89), -1) << column;
  for (int row = 0; row < 90; ++row) EXPECT_GE(at(159, row), -1) << row;
}

// The light moves with the camera and, here, with the body; the floor does not.
TEST_F(FloorTest, IsAtRestUnderAMovingCamera) {
  const auto seen = [&](double azimuth, double orbit) {
    scene::Scene scene = t_wrench(320, 180);
    scene.camera.azimuth = azimuth;
    scene.camera.orbit = orbit;
    return change(scene, so3::exp(Vector3d(0, azimuth, 0)));
  };
  const auto differing = [&](double orbit) {
    const std::vector<int> here = seen(0, orbit), there = seen(0.5, orbit);
    int count = 0;
    for (std::size_t i = 0; i < here.size(); ++i) count += std::abs(here[i] - there[i]) > 1 ? 1 : 0;
    return count;
  };
  EXPECT_LT(differing(0), 10) << "a still camera";
  EXPECT_GT(differing(0.1), 300);
}

TEST_F(FloorTest, IsNotThereWhereItCannotBe) {
  const Matrix3d Id = Matrix3d::Identity();
  scene::Scene below = t_wrench(160, 90);
  below.camera.elevation = -0.2;
  scene::Scene clear = t_wrench(160, 90);
  clear.look.transparent = true;
  scene::Scene space = t_wrench(160, 90);
  space.look.theme = scene::Theme::space;
  for (const scene::Scene& scene : {below, clear, space}) {
    EXPECT_EQ(drawn(scene, Id, {scene::Feature::floor}).pixels, drawn(scene, Id, {}).pixels);
  }
}

// The wire is ten million radii long: too many for a sphere per radius.
TEST_F(FloorTest, IsDrawnBelowAWire) {
  scene::Scene scene = white();
  scene.body.parts = {cylinder(1e-6, 10, {0, 0, 0}, {1, 1, 1})};
  scene.motion.omega.setZero();
  EXPECT_NO_THROW(change(scene, Matrix3d::Identity()));
}

}  // namespace
}  // namespace twrench::draw
