// The contents of the views, compared with the mechanics they show.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "gl/test_context.h"
#include "render/body/bounding_radius.h"
#include "render/drawn_layers.h"
#include "render/overlay/body_overlay.h"
#include "render/overlay/trail_point.h"
#include "render/t_wrench.h"
#include "render/views/body_view.h"
#include "render/views/momentum_view.h"
#include "render/views/poinsot_view.h"

namespace twrench::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

scene::Scene with(std::set<scene::Feature> features, int width = 320, int height = 180) {
  scene::Scene scene = t_wrench(width, height);
  scene.look.transparent = true;
  scene.overlay.show = std::move(features);
  return scene;
}

class SpaceViews : public testing::Test {
 protected:
  std::unique_ptr<gl::Context> context = gl::make_test_context();
  gl::Functions gl{*context};
  gl::Framebuffer framebuffer{gl, 320, 180, 4, gl::ReadMode::at_once};
  Layout::Pane pane{{0, 0, 320, 180}, {0, 0, 320, 180}};

  image::Image drawn_picture(SpaceView& view, const timeline::FrameState& state) const {
    image::Image picture(framebuffer.width(), framebuffer.height(), 4);
    for (const Layer& layer : drawn_layers(view, state)) composite_over(picture, layer);
    return picture;
  }
};

TEST(TrailPoint, IsOutsideTheTipOfTheLegSoFarThatItsTrailPassesOverTheRim) {
  const Vector3d point = trail_point(t_wrench());
  EXPECT_LT((point - Vector3d(4.24, 0, 0)).norm(), 1e-12);
  const Vector3d rim(4, 1, 0);
  EXPECT_GT(point.norm(), rim.norm() + 0.1) << "with half the trail's width";
}

TEST(TrailPoint, IsTheScenesFromTheCentreOfMass) {
  scene::Scene scene = t_wrench();
  for (body::Part& part : scene.body.parts) part.position += Vector3d(5, 6, 7);
  scene.overlay.trail_point = Vector3d(5, 7, 7);
  EXPECT_LT((trail_point(scene) - Vector3d(0, 1, 0)).norm(), 1e-12);
}

TEST(TrailPoint, ExistsWhereAllEndsAreAlike) {
  scene::Scene scene = t_wrench();
  scene.body.parts = {{body::Ellipsoid{{1, 1, 1}}, 1, {0, 0, 0}, Matrix3d::Identity()}};
  EXPECT_NEAR(trail_point(scene).norm(), 1.06, 1e-12);
}

TEST(BodyOverlay, KeepsTheTipOfOmegaOnTheInvariablePlane) {
  scene::Scene scene =
      with({scene::Feature::momentum, scene::Feature::omega, scene::Feature::plane});
  const timeline::Timeline timeline(scene, {0, 100, 300, 500, 900});
  const double radius = bounding_radius(scene::visible_parts(scene.body));
  const BodyOverlay overlay(scene, timeline.solutions()[0].body, radius);
  const Vector3d up = timeline.solutions()[0].body.momentum().normalized();
  EXPECT_GT(overlay.plane_height(), radius) << "outside the body";
  EXPECT_GT(overlay.momentum_tip().dot(up), overlay.plane_height()) << "pierced by L";
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const motion::Sample sample = timeline.frame_state(i).solutions[0].sample;
    EXPECT_NEAR(overlay.omega_tip(sample).dot(up), overlay.plane_height(), 1e-6 * radius);
    EXPECT_LT(overlay.omega_tip(sample).cross(sample.X * sample.omega).norm(), 1e-12 * radius);
  }
}

TEST(BodyOverlay, BoundsALongOmega) {
  scene::Scene scene =
      with({scene::Feature::momentum, scene::Feature::omega, scene::Feature::plane});
  scene.body = {{}, Vector3d(0.01, 1, 1.005).asDiagonal()};
  scene.motion.omega = {20, 1, 0};
  scene.motion.duration = 1;
  const timeline::Timeline timeline(scene, {0, 5});
  const BodyOverlay overlay(scene, timeline.solutions()[0].body, 3);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    EXPECT_LT(overlay.omega_tip(timeline.frame_state(i).solutions[0].sample).norm(), 4.6);
  }
}

TEST_F(SpaceViews, DrawArrowsWhereTheMatricesSayAndInView) {
  for (const double azimuth : {0.0, 0.9, 2.0, std::numbers::pi / 2}) {
    scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels});
    scene.camera.azimuth = azimuth;
    const timeline::Timeline timeline(scene, {0});
    BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
    const timeline::FrameState state = timeline.frame_state(0);
    const Camera camera = view.camera(0);
    const BodyOverlay overlay(scene, timeline.solutions()[0].body,
                              bounding_radius(scene::visible_parts(scene.body)));
    const Vector3d tip = overlay.momentum_tip();
    const auto labels = view.labels(state);
    ASSERT_EQ(labels.size(), 1) << azimuth;
    EXPECT_EQ(labels[0].text, "L");
    EXPECT_LT((labels[0].anchor - pixel_of(camera, pane.area, tip)).norm(), 1e-9);
    // Within the head, which has the colour of L.
    const Vector2d inside = pixel_of(camera, pane.area, 0.97 * tip);
    const image::Image picture = drawn_picture(view, state);
    const auto x = static_cast<int>(inside.x()), y = static_cast<int>(inside.y());
    ASSERT_TRUE(x >= 0 && y >= 0 && x < picture.width && y < picture.height) << azimuth;
    const std::uint8_t* p = &picture.pixels[static_cast<std::size_t>(4 * (y * picture.width + x))];
    EXPECT_GT(p[3], 250) << azimuth;
    EXPECT_GT(p[0], p[2] + 40) << "yellow, " << azimuth;
  }
}

/// The largest difference of any channel of any pixel.
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
  const auto picture = [&](bool omega, int samples) {
    scene.look.samples = samples;
    scene.overlay.show.clear();
    if (omega) scene.overlay.show.insert(scene::Feature::omega);
    const timeline::Timeline timeline(scene, {0});
    BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
    return drawn_picture(view, timeline.frame_state(0));
  };
  for (const int samples : {1, 4}) {
    const image::Image without = picture(false, samples);
    const int behind = largest_difference(picture(true, samples), without);
    EXPECT_GT(behind, 10) << "visible";
    EXPECT_LT(behind, 90) << "but faint";
    scene.camera.azimuth = std::numbers::pi / 2;
    EXPECT_GT(largest_difference(picture(true, samples), picture(false, samples)), 120);
    scene.camera.azimuth = -std::numbers::pi / 2;
  }
}

// Where an arrow leaves the body's flank it must not end in a step, which would be jagged.
TEST_F(SpaceViews, FadeArrowsWhereTheyEnterTheBody) {
  scene::Scene scene = with({scene::Feature::momentum});
  const timeline::Timeline timeline(scene, {71});
  scene.overlay.show.clear();
  BodyView bare(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  scene.overlay.show.insert(scene::Feature::momentum);
  BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  const timeline::FrameState state = timeline.frame_state(0);
  const image::Image picture = drawn_picture(view, state);
  const Camera camera = view.camera(0);
  const BodyOverlay overlay(scene, timeline.solutions()[0].body,
                            bounding_radius(scene::visible_parts(scene.body)));
  // Along the middle of L: how much of its colour, yellow, there is.
  std::vector<double> yellow;
  for (int i = 0; i <= 400; ++i) {
    const Vector2d place = pixel_of(camera, pane.area, i / 400.0 * overlay.momentum_tip());
    const auto x = static_cast<int>(place.x()), y = static_cast<int>(place.y());
    const std::uint8_t* p = &picture.pixels[static_cast<std::size_t>(4 * (y * picture.width + x))];
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
  BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  const timeline::FrameState state = timeline.frame_state(0);
  const image::Image picture = drawn_picture(view, state);
  const Vector2d place =
      pixel_of(view.camera(0), pane.area, state.solutions[0].sample.X * trail_point(scene));
  const auto luminance = [&](const Vector2d& at) {
    const auto x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
    return picture.pixels[static_cast<std::size_t>(4 * (y * picture.width + x))];
  };
  EXPECT_GT(luminance(place), 240) << "white";
  // All around it, but for where the trail comes from, the halo is dark.
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

TEST_F(SpaceViews, PutTheMomentumOnItsSphereAndLevel) {
  scene::Scene scene = with({});
  const timeline::Timeline timeline(scene, {0, 200, 400});
  const MomentumView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const motion::Sample sample = timeline.frame_state(i).solutions[0].sample;
    const Vector3d place = view.place_of(sample);
    EXPECT_NEAR(place.norm(), 1, 1e-9);
    // The wrench's axis of least moment, y, points up, and the intermediate one, x, towards the
    // viewer.
    EXPECT_GT(place.y() * sample.omega.y(), 0);
    EXPECT_GT(place.z() * sample.omega.x(), 0);
  }
}

TEST_F(SpaceViews, ShowTheSpheresAxesWholeInPanesOfAnyShape) {
  scene::Scene scene = with({scene::Feature::labels});
  for (const double orbit : {0.0, 0.4}) {
    scene.camera.orbit = orbit;
    const timeline::Timeline timeline(scene, {0, 300, 600});
    for (const auto& [width, height] : {std::pair(20, 180), {100, 180}, {170, 180}, {320, 60}}) {
      const image::Area all{0, 0, width, height};
      const MomentumView view(gl, framebuffer, scene, timeline.solutions(), 0, {all, all});
      for (std::size_t i = 0; i < timeline.size(); ++i) {
        EXPECT_EQ(view.labels(timeline.frame_state(i)).size(), 4U) << width << "x" << height;
      }
    }
  }
}

TEST_F(SpaceViews, RollTheEllipsoidOnThePlane) {
  scene::Scene scene = with({});
  scene.motion.omega = {1, 0.2, -0.1};
  const timeline::Timeline timeline(scene, {0, 77, 200, 400, 901});
  const PoinsotView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const motion::Sample sample = timeline.frame_state(i).solutions[0].sample;
    const Vector3d contact = view.contact(sample);
    const Matrix3d unit_from_view = view.ellipsoid(sample.X).inverse();
    EXPECT_NEAR(contact.y(), 1, 1e-7) << "on the plane";
    EXPECT_NEAR((unit_from_view * contact).norm(), 1, 1e-7) << "on the ellipsoid";
    const Vector3d normal = unit_from_view.transpose() * (unit_from_view * contact);
    EXPECT_LT(normal.normalized().cross(Vector3d::UnitY()).norm(), 1e-7) << "touching";
  }
  // Without slipping: the body's point at the contact is at rest.
  const motion::ExactMotion motion(timeline.solutions()[0].body);
  const double t = 7, h = 1e-4;
  const motion::Sample now = motion.at(t);
  const Vector3d point = view.ellipsoid(now.X).inverse() * view.contact(now);
  const Vector3d moved =
      (view.ellipsoid(motion.at(t + h).X) - view.ellipsoid(motion.at(t - h).X)) * point / (2 * h);
  EXPECT_LT(moved.norm(), 1e-6);
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
    std::vector<std::unique_ptr<SpaceView>> views;
    views.push_back(
        std::make_unique<BodyView>(gl, framebuffer, scene, timeline.solutions(), 0, pane));
    views.push_back(
        std::make_unique<MomentumView>(gl, framebuffer, scene, timeline.solutions(), 0, pane));
    views.push_back(
        std::make_unique<PoinsotView>(gl, framebuffer, scene, timeline.solutions(), 0, pane));
    for (const auto& view : views) {
      EXPECT_TRUE(view->camera(0).view.allFinite()) << odd.name;
      view->static_layers();
      for (const Layer& layer : drawn_layers(*view, state))
        EXPECT_GT(layer.image.width, 0) << odd.name;
      for (const Label& label : view->labels(state)) {
        EXPECT_TRUE(label.anchor.allFinite() && label.away.allFinite()) << odd.name;
      }
    }
  }
}

TEST_F(SpaceViews, KeepTheArrowsInViewOfACameraThatGoesAround) {
  scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels}, 180, 180);
  scene.camera.orbit = 1;
  const timeline::Timeline timeline(scene, {0});
  const Layout::Pane square{{0, 0, 180, 180}, {0, 0, 180, 180}};
  const BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, square);
  const double distance = view.camera(0).distance;
  for (int i = 0; i < 30; ++i) {
    timeline::FrameState state = timeline.frame_state(0);
    state.video_time = 0.2 * i;
    EXPECT_EQ(view.labels(state).size(), 1) << state.video_time;
    EXPECT_EQ(view.camera(state.video_time).distance, distance) << "no breathing";
  }
}

TEST_F(SpaceViews, ShowEachTakeItsOwn) {
  scene::Scene scene = with({scene::Feature::omega, scene::Feature::labels});
  scene.overlay.compare = {"exact", "lie-euler"};
  const timeline::Timeline timeline(scene, {600});
  const timeline::FrameState state = timeline.frame_state(0);
  const BodyView one(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  const BodyView other(gl, framebuffer, scene, timeline.solutions(), 1, pane);
  EXPECT_GT((one.labels(state).at(0).anchor - other.labels(state).at(0).anchor).norm(), 2);
}

TEST_F(SpaceViews, HaveTheBodyAtRestInItsOwnFrame) {
  scene::Scene scene = with({scene::Feature::trail});
  scene.camera.frame = scene::Frame::body;
  scene.look.motion_blur = 3;
  const timeline::Timeline timeline(scene, {0, 100, 333});
  BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  const Vector3d point(1, -2, 0.5);
  const image::Image first = drawn_picture(view, timeline.frame_state(0));
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const timeline::FrameState state = timeline.frame_state(i);
    const Camera camera = view.camera_in_space(state);
    const Vector3d place = state.solutions[0].sample.X * point;
    EXPECT_LT(
        (pixel_of(camera, pane.area, place) - pixel_of(view.camera(0), pane.area, point)).norm(),
        1e-9);
    const image::Image picture = drawn_picture(view, state);
    int apart = 0;
    for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
      apart = std::max(apart, std::abs(int{picture.pixels[k]} - int{first.pixels[k]}));
    }
    EXPECT_LE(apart, 12) << i;  // of edges, by round-off
  }
}

TEST_F(SpaceViews, HaveASteadyRotationAtRestInTheRotatingFrame) {
  scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels});
  scene.motion.omega = {1, 0, 0};
  scene.camera.frame = scene::Frame::rotating;
  const timeline::Timeline timeline(scene, {0, 77});
  const BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  const timeline::FrameState state = timeline.frame_state(1);
  const Vector3d point(1, -2, 0.5);
  const Vector2d pixel =
      pixel_of(view.camera_in_space(state), pane.area, state.solutions[0].sample.X * point);
  EXPECT_LT((pixel - pixel_of(view.camera(0), pane.area, point)).norm(), 1e-6);
  const auto start = view.labels(timeline.frame_state(0)), later = view.labels(state);
  ASSERT_EQ(later.size(), 1U);
  EXPECT_LT((start[0].anchor - later[0].anchor).norm(), 1e-6) << "L is the frame's axis";
}

TEST_F(SpaceViews, KeepTheArrowsInViewInATurningFrame) {
  scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels});
  scene.camera.frame = scene::Frame::body;
  const timeline::Timeline timeline(scene, {0, 60, 118, 180, 236, 300, 700});
  const BodyView view(gl, framebuffer, scene, timeline.solutions(), 0, pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    EXPECT_EQ(view.labels(timeline.frame_state(i)).size(), 1U) << i;
  }
}

}  // namespace
}  // namespace twrench::render
