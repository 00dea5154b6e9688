// The contents of the views, compared with the mechanics they show.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "gl/test_context.h"
#include "render/body_overlay.h"
#include "render/drawn_layers.h"
#include "render/momentum_view.h"
#include "render/poinsot_view.h"
#include "render/reach.h"
#include "render/t_wrench.h"
#include "render/trail_point.h"
#include "render/wrench_view.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Scene with(std::set<Feature> features, int width = 320, int height = 180) {
  Scene scene = t_wrench(width, height);
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

  Image drawn_picture(Element& element, const Moment& moment) const {
    Image picture(framebuffer.width(), framebuffer.height(), 4);
    for (const Layer& layer : drawn_layers(element, moment)) lay_over(picture, layer);
    return picture;
  }
};

TEST(TrailPoint, IsJustOutsideTheTipOfTheLeg) {
  EXPECT_LT((trail_point(t_wrench()) - Vector3d(4.12, 0, 0)).norm(), 1e-12);
}

TEST(TrailPoint, IsTheScenesFromTheCentreOfMass) {
  Scene scene = t_wrench();
  for (Part& part : scene.body.parts) part.position += Vector3d(5, 6, 7);
  scene.overlay.trail_point = Vector3d(5, 7, 7);
  EXPECT_LT((trail_point(scene) - Vector3d(0, 1, 0)).norm(), 1e-12);
}

TEST(TrailPoint, ExistsWhereAllEndsAreAlike) {
  Scene scene = t_wrench();
  scene.body.parts = {{Ellipsoid{{1, 1, 1}}, 1, {0, 0, 0}, Matrix3d::Identity()}};
  EXPECT_NEAR(trail_point(scene).norm(), 1.03, 1e-12);
}

TEST(BodyOverlay, KeepsTheTipOfOmegaOnTheInvariablePlane) {
  Scene scene = with({Feature::momentum, Feature::omega, Feature::plane});
  const Timeline timeline(scene, {0, 100, 300, 500, 900});
  const double radius = reach(visible_parts(scene.body));
  const BodyOverlay overlay(scene, timeline.takes()[0], radius);
  const Vector3d up = timeline.takes()[0].body.momentum().normalized();
  EXPECT_GT(overlay.plane_height(), radius) << "outside the body";
  EXPECT_GT(overlay.momentum_tip().dot(up), overlay.plane_height()) << "pierced by L";
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const Sample sample = timeline.moment(i).instants[0].sample;
    EXPECT_NEAR(overlay.omega_tip(sample).dot(up), overlay.plane_height(), 1e-6 * radius);
    EXPECT_LT(overlay.omega_tip(sample).cross(sample.X * sample.omega).norm(), 1e-12 * radius);
  }
}

TEST(BodyOverlay, BoundsALongOmega) {
  Scene scene = with({Feature::momentum, Feature::omega, Feature::plane});
  scene.body = {{}, Vector3d(0.01, 1, 1.005)};
  scene.motion.omega = {20, 1, 0};
  scene.motion.duration = 1;
  const Timeline timeline(scene, {0, 5});
  const BodyOverlay overlay(scene, timeline.takes()[0], 3);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    EXPECT_LT(overlay.omega_tip(timeline.moment(i).instants[0].sample).norm(), 4.6);
  }
}

TEST_F(SpaceViews, DrawArrowsWhereTheMatricesSayAndInView) {
  for (const double azimuth : {0.0, 0.9, 2.0, std::numbers::pi / 2}) {
    Scene scene = with({Feature::momentum, Feature::labels});
    scene.camera.azimuth = azimuth;
    const Timeline timeline(scene, {0});
    WrenchView view(gl, framebuffer, scene, timeline.takes(), 0, pane);
    const Moment moment = timeline.moment(0);
    const Camera camera = view.camera(0);
    const BodyOverlay overlay(scene, timeline.takes()[0], reach(visible_parts(scene.body)));
    const Vector3d tip = overlay.momentum_tip();
    const auto labels = view.labels(moment);
    ASSERT_EQ(labels.size(), 1) << azimuth;
    EXPECT_EQ(labels[0].text, "L");
    EXPECT_LT((labels[0].anchor - pixel_of(camera, pane.area, tip)).norm(), 1e-9);
    // Within the head, which has the colour of L.
    const Vector2d inside = pixel_of(camera, pane.area, 0.97 * tip);
    const Image picture = drawn_picture(view, moment);
    const auto x = static_cast<int>(inside.x()), y = static_cast<int>(inside.y());
    ASSERT_TRUE(x >= 0 && y >= 0 && x < picture.width && y < picture.height) << azimuth;
    const std::uint8_t* p = &picture.pixels[static_cast<std::size_t>(4 * (y * picture.width + x))];
    EXPECT_GT(p[3], 250) << azimuth;
    EXPECT_GT(p[0], p[2] + 40) << "yellow, " << azimuth;
  }
}

TEST_F(SpaceViews, HideWhatIsBehindTheBody) {
  // Straight along L, which the leg then covers from behind.
  Scene scene = with({Feature::omega});
  scene.camera.azimuth = -std::numbers::pi / 2;
  scene.camera.elevation = 0;
  const auto pictures = [&](bool omega) {
    scene.overlay.show.clear();
    if (omega) scene.overlay.show.insert(Feature::omega);
    const Timeline timeline(scene, {0});
    WrenchView view(gl, framebuffer, scene, timeline.takes(), 0, pane);
    return drawn_picture(view, timeline.moment(0));
  };
  const Image with_omega = pictures(true), without = pictures(false);
  EXPECT_EQ(with_omega.pixels, without.pixels);
  scene.camera.azimuth = std::numbers::pi / 2;
  EXPECT_NE(pictures(true).pixels, without.pixels);
}

TEST_F(SpaceViews, PutTheMomentumOnItsSphereAndLevel) {
  Scene scene = with({});
  const Timeline timeline(scene, {0, 200, 400});
  const MomentumView view(gl, framebuffer, scene, timeline.takes(), 0, pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const Sample sample = timeline.moment(i).instants[0].sample;
    const Vector3d place = view.place_of(sample);
    EXPECT_NEAR(place.norm(), 1, 1e-9);
    // The wrench's axis of least moment, y, points up, and the intermediate one, x, towards the
    // viewer.
    EXPECT_GT(place.y() * sample.omega.y(), 0);
    EXPECT_GT(place.z() * sample.omega.x(), 0);
  }
}

TEST_F(SpaceViews, ShowTheSpheresAxesWholeInPanesOfAnyShape) {
  Scene scene = with({Feature::labels});
  for (const double orbit : {0.0, 0.4}) {
    scene.camera.orbit = orbit;
    const Timeline timeline(scene, {0, 300, 600});
    for (const auto& [width, height] : {std::pair(20, 180), {100, 180}, {170, 180}, {320, 60}}) {
      const Area all{0, 0, width, height};
      const MomentumView view(gl, framebuffer, scene, timeline.takes(), 0, {all, all});
      for (std::size_t i = 0; i < timeline.size(); ++i) {
        EXPECT_EQ(view.labels(timeline.moment(i)).size(), 4U) << width << "x" << height;
      }
    }
  }
}

TEST_F(SpaceViews, RollTheEllipsoidOnThePlane) {
  Scene scene = with({});
  scene.motion.omega = {1, 0.2, -0.1};
  const Timeline timeline(scene, {0, 77, 200, 400, 901});
  const PoinsotView view(gl, framebuffer, scene, timeline.takes(), 0, pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const Sample sample = timeline.moment(i).instants[0].sample;
    const Vector3d contact = view.contact(sample);
    const Matrix3d unit_from_view = view.ellipsoid(sample.X).inverse();
    EXPECT_NEAR(contact.y(), 1, 1e-7) << "on the plane";
    EXPECT_NEAR((unit_from_view * contact).norm(), 1, 1e-7) << "on the ellipsoid";
    const Vector3d normal = unit_from_view.transpose() * (unit_from_view * contact);
    EXPECT_LT(normal.normalized().cross(Vector3d::UnitY()).norm(), 1e-7) << "touching";
  }
  // Without slipping: the body's point at the contact is at rest.
  const ExactMotion motion(timeline.takes()[0].body);
  const double t = 7, h = 1e-4;
  const Sample now = motion.at(t);
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
    Scene scene = with({Feature::axes, Feature::momentum, Feature::omega, Feature::trail,
                        Feature::plane, Feature::labels});
    scene.body = {{}, odd.moments};
    scene.motion.omega = odd.omega;
    scene.motion.duration = 2;
    scene.overlay.trail_length = 1e-9;  // a single point
    const Timeline timeline(scene, {0, 15});
    const Moment moment = timeline.moment(1);
    std::vector<std::unique_ptr<SpaceView>> views;
    views.push_back(
        std::make_unique<WrenchView>(gl, framebuffer, scene, timeline.takes(), 0, pane));
    views.push_back(
        std::make_unique<MomentumView>(gl, framebuffer, scene, timeline.takes(), 0, pane));
    views.push_back(
        std::make_unique<PoinsotView>(gl, framebuffer, scene, timeline.takes(), 0, pane));
    for (const auto& view : views) {
      EXPECT_TRUE(view->camera(0).view.allFinite()) << odd.name;
      view->still();
      for (const Layer& layer : drawn_layers(*view, moment))
        EXPECT_GT(layer.image.width, 0) << odd.name;
      for (const Label& label : view->labels(moment)) {
        EXPECT_TRUE(label.anchor.allFinite() && label.away.allFinite()) << odd.name;
      }
    }
  }
}

TEST_F(SpaceViews, KeepTheArrowsInViewOfACameraThatGoesAround) {
  Scene scene = with({Feature::momentum, Feature::labels}, 180, 180);
  scene.camera.orbit = 1;
  const Timeline timeline(scene, {0});
  const Layout::Pane square{{0, 0, 180, 180}, {0, 0, 180, 180}};
  const WrenchView view(gl, framebuffer, scene, timeline.takes(), 0, square);
  const double distance = view.camera(0).distance;
  for (int i = 0; i < 30; ++i) {
    Moment moment = timeline.moment(0);
    moment.film_time = 0.2 * i;
    EXPECT_EQ(view.labels(moment).size(), 1) << moment.film_time;
    EXPECT_EQ(view.camera(moment.film_time).distance, distance) << "no breathing";
  }
}

TEST_F(SpaceViews, ShowEachTakeItsOwn) {
  Scene scene = with({Feature::omega, Feature::labels});
  scene.overlay.compare = {"exact", "lie-euler"};
  const Timeline timeline(scene, {600});
  const Moment moment = timeline.moment(0);
  const WrenchView one(gl, framebuffer, scene, timeline.takes(), 0, pane);
  const WrenchView other(gl, framebuffer, scene, timeline.takes(), 1, pane);
  EXPECT_GT((one.labels(moment).at(0).anchor - other.labels(moment).at(0).anchor).norm(), 2);
}

}  // namespace
}  // namespace twrench
