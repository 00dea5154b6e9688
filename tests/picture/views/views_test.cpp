// Compares the contents of the views with the mechanics that they show.
#include <gmock/gmock.h>
#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "picture/body/bounding_radius.h"
#include "picture/compose/layout.h"
#include "picture/overlay/body_overlay.h"
#include "picture/overlay/trail_point.h"
#include "picture/overlay_scene.h"
#include "picture/t_wrench.h"
#include "picture/views/body_view.h"
#include "picture/views/momentum_view.h"
#include "picture/views/poinsot_view.h"
#include "picture/views/shown.h"
#include "picture/views/sphere_curves.h"
#include "sanitizers.h"
#include "timeline/film_timeline.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

const Layout::Pane whole_pane{{0, 0, 320, 180}, {0, 0, 320, 180}};

scene::Scene with(std::set<scene::Feature> features, int width = 320, int height = 180) {
  scene::Scene scene = t_wrench(width, height);
  scene.look.transparent = true;
  scene.overlay.show = std::move(features);
  return scene;
}

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

// Its camera is closer than the one that fits the satellite in every pose.
TEST(Views, ShowTheWholeSatelliteInPicturesOfAnyShape) {
  if (has_sanitizers) GTEST_SKIP() << "repeats the computation with other numbers";
  scene::Scene film = scene::load_scene("explorer-1");
  const double centre = scene::mass_properties(film.body).centre_of_mass.norm();
  const Vector3d axis = scene::mass_properties(film.body).axes.col(0);
  std::vector<int> frames;
  for (int i = 0; i < film.frame_count(); i += 20) frames.push_back(i);
  const timeline::FilmTimeline timeline(film, frames);
  for (const auto& [width, height] : {std::pair(270, 480), {480, 480}, {480, 270}}) {
    for (std::size_t i = 0; i < timeline.size(); ++i) {
      const std::size_t shot = timeline.shot(i);
      scene::Scene scene = film.shots[shot].scene;
      scene.film.width = width;
      scene.film.height = height;
      const Layout::Pane body_pane = compute_layout(scene).panes.front();
      const BodyView view(scene, timeline.solutions(shot), 0, body_pane, 101.6 + centre);
      for (const double end : {101.6 - centre, -101.6 - centre}) {
        const Matrix3d X = timeline.frame(i).state.solutions[0].sample.X;
        const Vector2d pixel = pixel_of(view.camera(0), body_pane.area, end * (X * axis));
        EXPECT_TRUE(pixel.x() > 0 && pixel.x() < width && pixel.y() > 0 && pixel.y() < height)
            << width << "x" << height << ", frame " << frames[i] << ": " << pixel.transpose();
      }
    }
  }
}

TEST(Views, PutTheMomentumOnItsSphereAndLevel) {
  scene::Scene scene = with({});
  const timeline::Timeline timeline(scene, {0, 200, 400});
  const MomentumView view(scene, timeline.solutions(), 0, whole_pane);
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

TEST(Views, ShowTheSpheresAxesWholeInPanesOfAnyShape) {
  scene::Scene scene = with({scene::Feature::labels});
  for (const double orbit : {0.0, 0.4}) {
    scene.camera.orbit = orbit;
    const timeline::Timeline timeline(scene, {0, 300, 600});
    for (const auto& [width, height] : {std::pair(20, 180), {100, 180}, {170, 180}, {320, 60}}) {
      const image::Area all{0, 0, width, height};
      const MomentumView view(scene, timeline.solutions(), 0, {all, all});
      for (std::size_t i = 0; i < timeline.size(); ++i) {
        EXPECT_EQ(shown_by(view, timeline.frame_state(i)).labels.size(), 4U)
            << width << "x" << height;
      }
    }
  }
}

TEST(Views, RollTheEllipsoidOnThePlane) {
  scene::Scene scene = with({});
  scene.motion.omega = {1, 0.2, -0.1};
  const timeline::Timeline timeline(scene, {0, 77, 200, 400, 901});
  const PoinsotView view(scene, timeline.solutions(), 0, whole_pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    const motion::Sample sample = timeline.frame_state(i).solutions[0].sample;
    const Vector3d contact = view.contact(sample);
    const Matrix3d unit_from_view = view.ellipsoid(sample.X).inverse();
    EXPECT_NEAR(contact.y(), 1, 1e-7) << "on the plane";
    EXPECT_NEAR((unit_from_view * contact).norm(), 1, 1e-7) << "on the ellipsoid";
    const Vector3d normal = unit_from_view.transpose() * (unit_from_view * contact);
    EXPECT_LT(normal.normalized().cross(Vector3d::UnitY()).norm(), 1e-7) << "touching";
  }
  // The body rolls without slipping: its point at the contact is at rest.
  const motion::ExactMotion motion(timeline.solutions()[0].body);
  const double t = 7, h = 1e-4;
  const motion::Sample now = motion.at(t);
  const Vector3d point = view.ellipsoid(now.X).inverse() * view.contact(now);
  const Vector3d moved =
      (view.ellipsoid(motion.at(t + h).X) - view.ellipsoid(motion.at(t - h).X)) * point / (2 * h);
  EXPECT_LT(moved.norm(), 1e-6);
}

TEST(Views, KeepTheArrowsInViewOfACameraThatGoesAround) {
  scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels}, 180, 180);
  scene.camera.orbit = 1;
  const timeline::Timeline timeline(scene, {0});
  const Layout::Pane square{{0, 0, 180, 180}, {0, 0, 180, 180}};
  const BodyView view(scene, timeline.solutions(), 0, square);
  const double distance = view.camera(0).distance;
  for (int i = 0; i < 30; ++i) {
    timeline::FrameState state = timeline.frame_state(0);
    state.video_time = 0.2 * i;
    EXPECT_EQ(shown_by(view, state).labels.size(), 1) << state.video_time;
    EXPECT_EQ(view.camera(state.video_time).distance, distance) << "no breathing";
  }
}

TEST(Views, ShowEachTakeItsOwn) {
  scene::Scene scene = with({scene::Feature::omega, scene::Feature::labels});
  scene.overlay.compare = {"exact", "lie-euler"};
  const timeline::Timeline timeline(scene, {600});
  const timeline::FrameState state = timeline.frame_state(0);
  const BodyView one(scene, timeline.solutions(), 0, whole_pane);
  const BodyView other(scene, timeline.solutions(), 1, whole_pane);
  EXPECT_GT((shown_by(one, state).labels.at(0).anchor - shown_by(other, state).labels.at(0).anchor)
                .norm(),
            2);
}

TEST(Views, HaveASteadyRotationAtRestInTheRotatingFrame) {
  scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels});
  scene.motion.omega = {1, 0, 0};
  scene.camera.frame = scene::Frame::rotating;
  const timeline::Timeline timeline(scene, {0, 77});
  const BodyView view(scene, timeline.solutions(), 0, whole_pane);
  const timeline::FrameState state = timeline.frame_state(1);
  const Vector3d point(1, -2, 0.5);
  const Vector2d pixel =
      pixel_of(view.camera_in_space(state), whole_pane.area, state.solutions[0].sample.X * point);
  EXPECT_LT((pixel - pixel_of(view.camera(0), whole_pane.area, point)).norm(), 1e-6);
  const auto start = shown_by(view, timeline.frame_state(0)).labels,
             later = shown_by(view, state).labels;
  ASSERT_EQ(later.size(), 1U);
  EXPECT_LT((start[0].anchor - later[0].anchor).norm(), 1e-6) << "L is the frame's axis";
}

TEST(Views, KeepTheArrowsInViewInATurningFrame) {
  scene::Scene scene = with({scene::Feature::momentum, scene::Feature::labels});
  scene.camera.frame = scene::Frame::body;
  const timeline::Timeline timeline(scene, {0, 60, 118, 180, 236, 300, 700});
  const BodyView view(scene, timeline.solutions(), 0, whole_pane);
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    EXPECT_EQ(shown_by(view, timeline.frame_state(i)).labels.size(), 1U) << i;
  }
}

std::string description(const Eigen::Vector3d& moments, const Eigen::Vector3d& omega) {
  scene::Scene scene = t_wrench();
  scene.body = {{}, moments.asDiagonal()};
  scene.motion.omega = omega;
  const OverlayScene film(scene);
  const timeline::Solution& solution = film.timeline.solutions()[0];
  return MomentumView::description(solution, PrincipalFrame(solution.body, film.colors),
                                   scene.language);
}

TEST(PrincipalFrame, HasTheColoursOfTheBodysAxesOnlyIfAllCoincide) {
  const OverlayColors palette = style_of(scene::Theme::studio).overlay;
  const auto colors = [&](const Matrix3d& inertia) {
    return PrincipalFrame(motion::FreeBody(inertia, {1, 0, 0}), palette).colors;
  };
  const Matrix3d inertia = Vector3d(3, 2, 1).asDiagonal();
  const std::array own{palette.axis[2], palette.axis[1], palette.axis[0]};
  EXPECT_EQ(colors(inertia), own);
  Matrix3d turned = inertia;  // about z, the axis of least moment, which stays
  turned(0, 1) = turned(1, 0) = 0.5;
  EXPECT_EQ(colors(turned), palette.axis);
}

/// Returns the area of a triangle with great circles as sides (Van Oosterom and Strackee, 1983).
double spherical_area(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

// The curve consists of 240 chords.
TEST(PhaseCap, HasTheAreaOfTheGeometricPhase) {
  const Vector3d moments(3, 5, 9);
  const OverlayColors colors = style_of(scene::Theme::studio).overlay;
  for (const Vector3d& omega : {Vector3d(0, 0.4, 0.01 / 9), Vector3d(0.01, 0.4, 0),
                                Vector3d(1, 0.2, -0.1), Vector3d(0.2, -0.3, -1)}) {
    const motion::FreeBody body(moments.asDiagonal(), omega);
    const PrincipalFrame frame(body, colors);
    const std::optional<Cap> cap = phase_cap(body, frame);
    ASSERT_TRUE(cap);
    double area = 0;
    for (std::size_t i = 0; i + 1 < cap->rim.size(); ++i) {
      area += spherical_area(cap->middle, cap->rim[i], cap->rim[i + 1]);
    }
    EXPECT_NEAR(std::abs(area), std::abs(motion::ExactMotion(body).phase()->area()), 1e-3)
        << omega.transpose();
    EXPECT_GT(cap->middle.dot(frame.direction), 0);
  }
  for (const Vector3d& omega : {Vector3d(0, 1, 0), Vector3d(0, 0, 0)}) {
    const motion::FreeBody body(moments.asDiagonal(), omega);
    EXPECT_FALSE(phase_cap(body, PrincipalFrame(body, colors)));
  }
}

TEST(PhaseCap, IsDrawnOnTheSphere) {
  const auto shown = [](std::set<scene::Feature> features) {
    const scene::Scene scene = with(std::move(features));
    const timeline::Timeline timeline(scene, {0});
    const MomentumView view(scene, timeline.solutions(), 0, whole_pane);
    ViewContents contents;
    contents.begin(view.camera_in_space(timeline.frame_state(0)), view.pane().area);
    view.add_still(contents);
    return contents.translucent.vertices().size();
  };
  EXPECT_GT(shown({scene::Feature::phase}), shown({}) + 16 * 240);
}

TEST(MomentumDescription, IsTrueOfTheMotion) {
  EXPECT_THAT(description({1, 2, 3}, {0.01, 1, 0}), testing::HasSubstr("middle axis to the other"));
  EXPECT_THAT(description({2, 1, 3}, {1, 0.01, 0}), testing::HasSubstr("middle axis to the other"));
  for (const std::string& stable :
       {description({1, 2, 3}, {1, 0.01, 0}), description({1, 1, 3}, {1, 0.01, 0.3})}) {
    EXPECT_THAT(stable, testing::Not(testing::HasSubstr("turns over")));
    EXPECT_THAT(stable, testing::Not(testing::HasSubstr("bold")));
  }
  EXPECT_THAT(description({1, 2, 3}, {1, 0.01, 0}), testing::HasSubstr("about the least axis"));
  EXPECT_THAT(description({1, 2, 3}, {0, 0.01, 1}), testing::HasSubstr("about the greatest axis"));
  EXPECT_THAT(description({1, 1, 3}, {0, 0.01, 1}), testing::HasSubstr("about the z axis"));
  EXPECT_THAT(description({2, 2, 2}, {1, 0, 0}), testing::HasSubstr("stays where it is"));
  EXPECT_THAT(description({1, 2, 3}, {0, 0, 0}), testing::HasSubstr("at rest"));
}

}  // namespace
}  // namespace twrench::picture
