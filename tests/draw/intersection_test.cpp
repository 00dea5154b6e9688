// Tests that the edges where parts of a body enter each other are as smooth as in a picture of many
// samples.
#include <gtest/gtest.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "draw/pose_renderer.h"
#include "gl/test_context.h"
#include "picture/body/meshes.h"
#include "picture/t_wrench.h"
#include "sanitizers.h"

namespace twrench::draw {
namespace {

using Eigen::Vector3d;
using picture::part_of;
using picture::t_wrench;

constexpr int fineness = 4;  // of the reference, in pixels per pixel

/// A light and a dark part, both matte.
scene::Scene scene_of(const body::Part& light, const body::Part& dark) {
  scene::Scene scene = t_wrench(240, 136);
  scene.body.parts = {light, dark};
  scene.body.descriptions.resize(2);
  scene.body.descriptions[0].look.color = Color{230, 230, 230};
  scene.body.descriptions[1].look.color = Color{20, 20, 20};
  scene.motion.omega.setZero();
  scene.look.metallic = 0;
  scene.look.roughness = 1;
  scene.look.transparent = true;
  return scene;
}

/// Returns the green channel of the large picture, averaged over the square that shows the pixel.
double mean_of_square(const image::Image& large, int x, int y) {
  double sum = 0;
  for (int row = fineness * y; row < fineness * (y + 1); ++row) {
    for (int column = fineness * x; column < fineness * (x + 1); ++column) {
      sum += large.pixels[static_cast<std::size_t>(4 * (row * large.width + column) + 1)];
    }
  }
  return sum / (fineness * fineness);
}

/// Differences from a picture of four times the size with 4 samples, averaged to pixels, within the
/// body's outline.
struct Deviation {
  double worst = 0;
  int jagged = 0;  ///< The number of pixels that differ by more than a quarter of the contrast.
};

Deviation deviation(const image::Image& image, const image::Image& large) {
  const auto channel = [&](int x, int y, int number) {
    return image.pixels[static_cast<std::size_t>(4 * (y * image.width + x) + number)];
  };
  Deviation result;
  for (int y = 2; y < image.height - 2; ++y) {
    for (int x = 2; x < image.width - 2; ++x) {
      bool is_inside = true;
      for (int k = 0; k < 25; ++k) is_inside &= channel(x + k % 5 - 2, y + k / 5 - 2, 3) == 255;
      if (!is_inside) continue;
      const double difference = std::abs(channel(x, y, 1) - mean_of_square(large, x, y));
      result.worst = std::max(result.worst, difference);
      if (difference > 48) ++result.jagged;
    }
  }
  return result;
}

class Intersection : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();

  Deviation deviation_of(scene::Scene scene, const Eigen::Matrix3d& X) const {
    const image::Image image = PoseRenderer(*context, scene).draw(X);
    scene.film.width = fineness * scene.film.width;
    scene.film.height = fineness * scene.film.height;
    scene.look.samples = 4;
    return deviation(image, PoseRenderer(*context, scene).draw(X));
  }
};

TEST_F(Intersection, OfAnyTwoPartsIsAntialiased) {
  const auto turned = [](body::Part part) {
    part.body_from_part = so3::exp(Vector3d(0.3, 0.2, 0.1));
    part.position = {0.2, 0.1, 0.3};
    return part;
  };
  const body::Part box = part_of(picture::box_of_triangles({3, 2.4, 1}));
  const body::Part ball = part_of(picture::ball_of_triangles(0.9, 60));
  const body::Part slab = {body::Box{{3, 2.4, 1}}, 1, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  const body::Part egg = {
      body::Ellipsoid{{0.9, 0.8, 1}}, 1, {0, 0, 0}, Eigen::Matrix3d::Identity()};
  struct Case {
    const char* name;
    body::Part one, other;
    bool is_like_others = false;  ///< Under sanitizers the others suffice.
  };
  const Eigen::Matrix3d X = so3::exp(Vector3d(-0.4, 0.5, 0.6));
  for (const auto& [name, one, other, is_like_others] :
       {Case{"mesh and mesh", box, ball, true}, Case{"ball first", ball, box, true},
        Case{"shape and shape", slab, egg}, Case{"mesh and shape", box, egg}}) {
    if (has_sanitizers && is_like_others) continue;
    const auto [worst, jagged] = deviation_of(scene_of(one, turned(other)), X);
    EXPECT_LE(jagged, 4) << name << ": the largest difference is " << worst << " of 255";
  }
}

/// A light box with dark stripes of foil on its top, as close as print and paper.
scene::Scene box_with_stripes() {
  body::TriangleMesh stripes;
  for (int i = 0; i < 4; ++i) {
    const double left = -1.2 + 0.6 * i, width = 0.04 + 0.08 * i;
    const auto first = static_cast<std::uint32_t>(stripes.vertices.size());
    stripes.vertices.insert(stripes.vertices.end(), {{left, -0.9, 0.505},
                                                     {left + width, -0.9, 0.505},
                                                     {left + width + 0.1, 0.9, 0.505},
                                                     {left + 0.1, 0.9, 0.505}});
    stripes.triangles.insert(stripes.triangles.end(),
                             {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  }
  return scene_of(part_of(picture::box_of_triangles({3, 2.4, 1})), part_of(stripes, 0.001));
}

// Without a lift, the foil is hidden in part wherever the outline moves it by half a pixel over a
// slope.
TEST_F(Intersection, OfFoilAndThePartBelowIsAntialiased) {
  const auto [worst, jagged] = deviation_of(box_with_stripes(), so3::exp(Vector3d(-0.4, 0.5, 0.6)));
  EXPECT_LE(jagged, 4) << "the largest difference is " << worst << " of 255";
}

// Otherwise it would be lines of dots there.
TEST_F(Intersection, FoilIsNotDrawnWhereItIsSeenAlmostEdgeOn) {
  scene::Scene scene = box_with_stripes();
  scene.film.width *= 4;
  scene.film.height *= 4;
  PoseRenderer renderer(*context, scene);
  const Eigen::Matrix3d level = renderer.camera().camera_from_space().transpose() *
                                so3::exp(Vector3d(-0.5 * std::numbers::pi, 0, 0));
  const auto dark_pixels = [&](double tilt) {
    const image::Image image = renderer.draw(level * so3::exp(Vector3d(tilt, 0, 0)));
    int count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      if (image.pixels[i + 3] == 255 && image.pixels[i + 1] < 60) ++count;
    }
    return count;
  };
  // The top is seen if the box is tilted by more than the angle between the line of sight to it and
  // that to the centre.
  const double first_seen = std::asin(0.5 / renderer.camera().distance);
  EXPECT_GT(dark_pixels(first_seen + 0.3), 1000);
  EXPECT_EQ(dark_pixels(first_seen + 0.02), 0);
}

}  // namespace
}  // namespace twrench::draw
