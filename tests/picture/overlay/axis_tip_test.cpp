#include "picture/overlay/axis_tip.h"

#include <gtest/gtest.h>
#include <twrench/motion/rotating_frame.h>

#include <Eigen/Geometry>

#include "picture/body/bounding_radius.h"
#include "picture/t_wrench.h"
#include "picture/views/body_view.h"
#include "picture/views/shown.h"

namespace twrench::picture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const image::Area tip_pane{0, 0, 640, 480};

/// The T-wrench about its axes of greatest, least and intermediate moment, side by side.
scene::Scene three_axes(double tilt) {
  scene::Scene scene = t_wrench();
  scene.camera.frame = scene::Frame::rotating;
  scene.overlay.show = {scene::Feature::tip};
  scene.overlay.compare_omega = {{tilt, 0, 1}, {tilt, 1, 0}, {1, tilt, 0}};
  scene.motion.method = "exact";
  scene.motion.duration = 20;
  return scene;
}

/// Returns the attitude of the body in the camera's axes in a frame of a pane.
Matrix3d seen(const scene::Scene& scene, const timeline::Timeline& timeline, std::size_t pane,
              std::size_t frame) {
  const BodyView view(scene, timeline.solutions(), pane, {tip_pane, tip_pane}, 5);
  const timeline::FrameState state = timeline.frame_state(frame);
  return view.camera_in_space(state).camera_from_space() * state.solutions[pane].sample.X;
}

TEST(AxisTip, IsSeenInEachPaneFromThePanesOwnFrame) {
  const scene::Scene steady = three_axes(0);
  const timeline::Timeline timeline(steady, {0, 37, 111, 190});
  ASSERT_EQ(timeline.solutions().size(), 3U);
  for (std::size_t pane = 0; pane < 3; ++pane) {
    for (std::size_t frame = 1; frame < 4; ++frame) {
      EXPECT_LE((seen(steady, timeline, pane, frame) - seen(steady, timeline, pane, 0)).norm(),
                1e-9)
          << "a steady rotation is at rest in pane " << pane;
    }
  }
  // Unsteady ones turn with L / I of the nearest axis.
  const scene::Scene scene = three_axes(0.2);
  const timeline::Timeline motions(scene, {0, 111});
  const double t = motions.frame_state(1).solutions[0].sample.t;
  for (std::size_t pane = 0; pane < 3; ++pane) {
    const motion::FreeBody& body = motions.solutions()[pane].body;
    Eigen::Index axis = 0;
    body.omega().cwiseAbs().maxCoeff(&axis);
    const double angle = body.momentum().norm() / body.inertia()(axis, axis) * t;
    const Matrix3d turned =
        Eigen::AngleAxisd(angle, body.momentum().normalized()).toRotationMatrix();
    const BodyView view(scene, motions.solutions(), pane, {tip_pane, tip_pane}, 5);
    const Matrix3d before = view.camera_in_space(motions.frame_state(0)).camera_from_space();
    const Matrix3d after = view.camera_in_space(motions.frame_state(1)).camera_from_space();
    EXPECT_LE((after - before * turned.transpose()).norm(), 1e-9) << pane;
  }
}

TEST(AxisTip, HasOneScaleForTheArrowsOfAPane) {
  for (const double tilt : {1e-6, 1e-3, 0.3}) {
    const scene::Scene scene = three_axes(tilt);
    const timeline::Timeline timeline(scene, {0});
    for (const timeline::Solution& solution : timeline.solutions()) {
      const double radius = 5;
      const AxisTip tip(scene, solution, radius);
      const timeline::TipForces forces(solution.body);
      double longest = 0, farthest = 0;
      for (const motion::Sample& sample : solution.whole) {
        const auto [centrifugal, coriolis] = forces.at(sample);
        for (const Vector3d& force : {centrifugal, coriolis, Vector3d(centrifugal + coriolis)}) {
          longest = std::max(longest, tip.scale() / tip.distance() * force.norm());
        }
        const Vector3d up = solution.body.momentum().normalized();
        farthest = std::max(farthest, tip.distance() * (sample.X * forces.axis() - up).norm());
      }
      EXPECT_NEAR(longest, std::clamp(farthest, 0.2 * radius, 0.7 * radius), 1e-6);
    }
  }
}

/// Returns the vertices of the arrows and of the lines and dots.
std::pair<std::size_t, std::size_t> drawn(const scene::Scene& scene, int frame) {
  const timeline::Timeline timeline(scene, {frame});
  const BodyView view(scene, timeline.solutions(), 0, {tip_pane, tip_pane}, 5);
  const ViewContents contents = shown_by(view, timeline.frame_state(0));
  for (const DrawList::Vertex& vertex : contents.opaque.vertices()) {
    EXPECT_LT(std::abs(vertex.clip.x), vertex.clip.w) << "the camera keeps it in view";
    EXPECT_LT(std::abs(vertex.clip.y), vertex.clip.w);
  }
  return {contents.opaque.vertices().size(), contents.translucent.vertices().size()};
}

TEST(AxisTip, IsDrawnWithItsPathAndWithForcesIfTheBodyIsTilted) {
  scene::Scene scene = three_axes(0);
  scene.overlay.compare_omega.clear();
  scene.motion.omega = {0, 1, 0};
  const auto steady = drawn(scene, 100);
  EXPECT_GT(steady.first, 100U) << "the axis";
  scene.motion.omega = {0.2, 1, 0};
  const auto tilted = drawn(scene, 100);
  EXPECT_GT(tilted.first, 3 * steady.first) << "and three forces";
  EXPECT_GT(tilted.second, 2 * steady.second) << "the path";
}

TEST(AxisTip, MovesInACircleAboutTheLeastAxis) {
  scene::Scene scene = three_axes(0.1);
  const timeline::Timeline timeline(scene, {0});
  const timeline::Solution& least = timeline.solutions()[1];
  const timeline::TipForces forces(least.body);
  const Vector3d up = least.body.momentum().normalized();
  double turned = 0;
  Vector3d last = Vector3d::Zero();
  for (const motion::Sample& sample : least.whole) {
    const Matrix3d frame = motion::steady_frame(least.body, sample.t).attitude;
    const Vector3d tip = frame.transpose() * (sample.X * forces.axis());
    const Vector3d lean = (tip - tip.dot(up) * up).normalized();
    if (!last.isZero(0.0)) turned += std::atan2(up.dot(last.cross(lean)), last.dot(lean));
    last = lean;
  }
  EXPECT_GT(std::abs(turned), 2 * std::numbers::pi);
}

}  // namespace
}  // namespace twrench::picture
