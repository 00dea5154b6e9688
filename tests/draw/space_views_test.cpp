// Compares the pixels of the views with the mechanics.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>

#include "draw/body_painter.h"
#include "draw/draw_list_pass.h"
#include "gl/test_context.h"
#include "picture/body/bounding_radius.h"
#include "picture/overlay/body_overlay.h"
#include "picture/overlay/trail_point.h"
#include "picture/t_wrench.h"
#include "picture/views/body_view.h"
#include "picture/views/momentum_view.h"
#include "picture/views/poinsot_view.h"
#include "picture/views/shown.h"

namespace twrench::draw {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using picture::BodyOverlay;
using picture::BodyView;
using picture::bounding_radius;
using picture::Camera;
using picture::Layer;
using picture::Layout;
using picture::MomentumView;
using picture::pixel_of;
using picture::PoinsotView;
using picture::t_wrench;
using picture::trail_point;
using picture::View;
using picture::ViewContents;

scene::Scene with(std::set<scene::Feature> features, int width = 320, int height = 180) {
  scene::Scene scene = t_wrench(width, height);
  scene.look.transparent = true;
  scene.overlay.show = std::move(features);
  return scene;
}

std::vector<Layer> completed(std::vector<PendingLayer> pending) {
  std::vector<Layer> layers;
  for (PendingLayer& layer : pending) layers.push_back(std::get<Layer>(layer.finish()));
  return layers;
}

ViewContents still_of(const View& view) {
  ViewContents contents;
  contents.begin(view.camera(0), view.pane().area);
  view.add_still(contents);
  return contents;
}

class SpaceViews : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();
  gl::Functions gl{*context};
  gl::Framebuffer framebuffer{gl, 320, 180, 4, gl::ReadMode::at_once};
  Layout::Pane pane{{0, 0, 320, 180}, {0, 0, 320, 180}};

  image::Image drawn_picture(const BodyView& view, const scene::Scene& scene,
                             const timeline::FrameState& state) const {
    BodyPainter painter(gl, framebuffer, view, scene::visible_parts(scene.body),
                        scene.look.samples > 1);
    image::Image image(framebuffer.width(), framebuffer.height(), 4);
    for (const Layer& layer : completed(painter.draw(picture::shown_by(view, state)))) {
      composite_over(image, layer);
    }
    return image;
  }
};

TEST_F(SpaceViews, DrawArrowsWhereTheMatricesSayAndInView) {
  for (const double azimuth : {0.0, 0.9, 2.0, std::numbers::pi / 2}) {
    scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels});
    scene.camera.azimuth = azimuth;
    const timeline::Timeline timeline(scene, {0});
    BodyView view(scene, timeline.solutions(), 0, pane);
    const timeline::FrameState state = timeline.frame_state(0);
    const Camera camera = view.camera(0);
    const BodyOverlay overlay(scene, timeline.solutions()[0].body,
                              bounding_radius(scene::visible_parts(scene.body)));
    const Vector3d tip = overlay.momentum_tip();
    const auto labels = picture::shown_by(view, state).labels;
    ASSERT_EQ(labels.size(), 1) << azimuth;
    EXPECT_EQ(labels[0].text, "L");
    EXPECT_LT((labels[0].anchor - pixel_of(camera, pane.area, tip)).norm(), 1e-9);
    // Within the head, which has the colour of L.
    const Vector2d inside = pixel_of(camera, pane.area, 0.97 * tip);
    const image::Image image = drawn_picture(view, scene, state);
    const auto x = static_cast<int>(inside.x()), y = static_cast<int>(inside.y());
    ASSERT_TRUE(x >= 0 && y >= 0 && x < image.width && y < image.height) << azimuth;
    const std::uint8_t* p = &image.pixels[static_cast<std::size_t>(4 * (y * image.width + x))];
    EXPECT_GT(p[3], 250) << azimuth;
    EXPECT_GT(p[0], p[2] + 40) << "yellow, " << azimuth;
  }
}

/// Returns the largest difference of any channel of any pixel.
int largest_difference(const image::Image& a, const image::Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  }
  return largest;
}

TEST_F(SpaceViews, ShowFaintlyWhatIsBehindTheBody) {
  // Straight along L, which the leg then covers from behind.
  scene::Scene scene = with({scene::Feature::omega});
  scene.camera.azimuth = -std::numbers::pi / 2;
  scene.camera.elevation = 0;
  const auto picture_with = [&](bool omega, int samples) {
    scene.look.samples = samples;
    scene.overlay.show.clear();
    if (omega) scene.overlay.show.insert(scene::Feature::omega);
    const timeline::Timeline timeline(scene, {0});
    BodyView view(scene, timeline.solutions(), 0, pane);
    return drawn_picture(view, scene, timeline.frame_state(0));
  };
  for (const int samples : {1, 4}) {
    const image::Image without = picture_with(false, samples);
    const int behind = largest_difference(picture_with(true, samples), without);
    EXPECT_GT(behind, 10) << "visible";
    EXPECT_LT(behind, 90) << "but faint";
    scene.camera.azimuth = std::numbers::pi / 2;
    EXPECT_GT(largest_difference(picture_with(true, samples), picture_with(false, samples)), 120);
    scene.camera.azimuth = -std::numbers::pi / 2;
  }
}

// An arrow must not end in a step where it leaves the body's flank; the step would be jagged.
TEST_F(SpaceViews, FadeArrowsWhereTheyEnterTheBody) {
  scene::Scene scene = with({scene::Feature::momentum});
  const timeline::Timeline timeline(scene, {71});
  scene.overlay.show.clear();
  BodyView bare(scene, timeline.solutions(), 0, pane);
  scene.overlay.show.insert(scene::Feature::momentum);
  BodyView view(scene, timeline.solutions(), 0, pane);
  const timeline::FrameState state = timeline.frame_state(0);
  const image::Image image = drawn_picture(view, scene, state);
  const Camera camera = view.camera(0);
  const BodyOverlay overlay(scene, timeline.solutions()[0].body,
                            bounding_radius(scene::visible_parts(scene.body)));
  // Along the middle of L: the amount of its colour, yellow.
  std::vector<double> yellow;
  for (int i = 0; i <= 400; ++i) {
    const Vector2d place = pixel_of(camera, pane.area, i / 400.0 * overlay.momentum_tip());
    const auto x = static_cast<int>(place.x()), y = static_cast<int>(place.y());
    const std::uint8_t* p = &image.pixels[static_cast<std::size_t>(4 * (y * image.width + x))];
    yellow.push_back(p[0] - p[2]);
  }
  EXPECT_LT(yellow[40], 60) << "deep inside";
  EXPECT_GT(yellow[200], 100) << "outside";
  double steepest = 0;
  for (std::size_t i = 40; i + 3 < 240; ++i) {
    steepest = std::max(steepest, yellow[i + 3] - yellow[i]);
  }
  EXPECT_LT(steepest, 0.6 * (yellow[200] - yellow[40])) << "between neighbouring pixels";
}

TEST_F(SpaceViews, PutADotWhereTheTrailsPointIs) {
  scene::Scene scene = with({scene::Feature::trail});
  const timeline::Timeline timeline(scene, {105});
  BodyView view(scene, timeline.solutions(), 0, pane);
  const timeline::FrameState state = timeline.frame_state(0);
  const image::Image image = drawn_picture(view, scene, state);
  const Vector2d place =
      pixel_of(view.camera(0), pane.area, state.solutions[0].sample.X * trail_point(scene));
  const auto luminance = [&](const Vector2d& at) {
    const auto x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return image.pixels[static_cast<std::size_t>(4 * (y * image.width + x))];
  };
  EXPECT_GT(luminance(place), 240) << "white";
  // The halo is dark all around the dot, except on the side of the trail.
  int dark = 0;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * std::numbers::pi * i / 16;
    double least = 255;
    for (double reach = 1; reach < 4; reach += 0.25) {
      least = std::min<double>(
          least, luminance(place + reach * Vector2d(std::cos(angle), std::sin(angle))));
    }
    dark += least < 90 ? 1 : 0;
  }
  EXPECT_GE(dark, 11);
}

struct Odd {
  const char* name;
  Vector3d moments, omega;
};

TEST_F(SpaceViews, DrawEveryBody) {
  for (const Odd& odd :
       {Odd{"sphere", {2, 2, 2}, {1, 0, 0}}, Odd{"rest", {1, 2, 3}, {0, 0, 0}},
        Odd{"symmetric", {1, 1, 1.5}, {1, 0.2, 0.5}}, Odd{"equator", {1, 1, 1.5}, {1, 0.2, 0}},
        Odd{"needle", {1e-6, 1, 1}, {1, 1, 1}}, Odd{"plate", {1e9, 1e9, 2e9}, {0, 1, 0.1}},
        Odd{"spin", {1, 2, 2.5}, {0, 1, 0}}, Odd{"slow", {1, 2, 2.5}, {0, 1e-9, 0}}}) {
    scene::Scene scene =
        with({scene::Feature::axes, scene::Feature::momentum, scene::Feature::omega,
              scene::Feature::trail, scene::Feature::plane, scene::Feature::labels});
    scene.body = {{}, odd.moments.asDiagonal()};
    scene.motion.omega = odd.omega;
    scene.motion.duration = 2;
    scene.overlay.trail_length = 1e-9;  // a single point
    const timeline::Timeline timeline(scene, {0, 15});
    const timeline::FrameState state = timeline.frame_state(1);
    const BodyView body(scene, timeline.solutions(), 0, pane);
    const MomentumView momentum(scene, timeline.solutions(), 0, pane);
    const PoinsotView poinsot(scene, timeline.solutions(), 0, pane);
    BodyPainter body_painter(gl, framebuffer, body, scene::visible_parts(scene.body), false);
    DrawListPainter list_painter(gl, framebuffer, pane.area);
    const auto expect_drawn = [&](const View& view, ViewPainter& painter) {
      EXPECT_TRUE(view.camera(0).view.allFinite()) << odd.name;
      painter.draw_still(still_of(view));
      const ViewContents contents = picture::shown_by(view, state);
      for (const Layer& layer : completed(painter.draw(contents))) {
        EXPECT_GT(layer.image.width, 0) << odd.name;
      }
      for (const picture::Label& label : contents.labels) {
        EXPECT_TRUE(label.anchor.allFinite() && label.away.allFinite()) << odd.name;
      }
    };
    expect_drawn(body, body_painter);
    expect_drawn(momentum, list_painter);
    expect_drawn(poinsot, list_painter);
  }
}

TEST_F(SpaceViews, HaveTheBodyAtRestInItsOwnFrame) {
  scene::Scene scene = with({scene::Feature::trail});
  scene.camera.frame = scene::Frame::body;
  scene.look.motion_blur = 3;
  const timeline::Timeline timeline(scene, {0, 100, 333});
  BodyView view(scene, timeline.solutions(), 0, pane);
  const Vector3d point(1, -2, 0.5);
  const image::Image first = drawn_picture(view, scene, timeline.frame_state(0));
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const timeline::FrameState state = timeline.frame_state(i);
    const Camera camera = view.camera_in_space(state);
    const Vector3d place = state.solutions[0].sample.X * point;
    EXPECT_LT(
        (pixel_of(camera, pane.area, place) - pixel_of(view.camera(0), pane.area, point)).norm(),
        1e-9);
    const image::Image image = drawn_picture(view, scene, state);
    int apart = 0;
    for (std::size_t k = 0; k < image.pixels.size(); ++k) {
      apart = std::max(apart, std::abs(int{image.pixels[k]} - int{first.pixels[k]}));
    }
    EXPECT_LE(apart, 12) << i;  // at edges, by round-off
  }
}

}  // namespace
}  // namespace twrench::draw
