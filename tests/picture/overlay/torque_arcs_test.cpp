#include "picture/overlay/torque_arcs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/enumeration.h"
#include "picture/body/bounding_radius.h"
#include "picture/t_wrench.h"
#include "picture/views/body_view.h"
#include "picture/views/shown.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;
using timeline::TiltingTorque;

const image::Area arcs_pane{0, 0, 640, 480};

/// A scene at some times, seen from some directions.
struct Shown {
  explicit Shown(const scene::Scene& scene_shown)
      : scene(scene_shown),
        radius(bounding_radius(scene::visible_parts(scene.body))),
        timeline(scene, {0, scene.frame_count() / 9, scene.frame_count() / 4}),
        arcs(scene, timeline.solutions()[0], radius),
        torque(scene, timeline.solutions()[0].body) {}

  /// Calls `check` with each sample and camera.
  void for_each(const std::function<void(const motion::Sample&, const Camera&)>& check) const {
    for (std::size_t i = 0; i < timeline.size(); ++i) {
      const motion::Sample sample = timeline.frame_state(i).solutions[0].sample;
      for (double azimuth = -3; azimuth < 3; azimuth += 0.7) {
        for (const double elevation : {-1.2, 0.0, 0.3, 1.5}) {
          check(sample, frame_sphere({direction_of(azimuth, elevation), 0.55, 4.0 / 3,
                                      arcs.bounding_radius()}));
        }
      }
    }
  }

  scene::Scene scene;
  double radius;
  timeline::Timeline timeline;
  TorqueArcs arcs;
  TiltingTorque torque;
};

double length_on_screen(const TorqueArcs::Arc& arc, const Camera& camera) {
  double length = 0;
  for (std::size_t i = 1; i < arc.path.size(); ++i) {
    length +=
        (pixel_of(camera, arcs_pane, arc.path[i]) - pixel_of(camera, arcs_pane, arc.path[i - 1]))
            .norm();
  }
  return length;
}

std::vector<scene::Scene> rigid_scenes() {
  std::vector<scene::Scene> scenes;
  for (const std::string& name : scene::builtin_scene_names()) {
    scene::Scene scene = scene::load_scene(name);
    if (!scene.shots.empty()) scene = scene.shots[1].scene;
    if (!scene.motion.is_rigid() || !scene.overlay.compare_wheel.empty()) continue;
    scene.overlay.compare_omega.clear();
    scene.camera.frame = scene::Frame::rotating;
    scene.overlay.show.insert(scene::Feature::torques);
    scenes.push_back(scene);
  }
  return scenes;
}

TEST(TorqueArcs, AreOnTheScreenAsLongAsTheTorquesFromEverySide) {
  int compared = 0;
  for (const scene::Scene& scene : rigid_scenes()) {
    const Shown shown(scene);
    shown.for_each([&](const motion::Sample& sample, const Camera& camera) {
      const auto [further, back] = shown.torque.sides(sample);
      const double pixels = 0.5 * arcs_pane.height * camera.projection(1, 1) / camera.distance;
      const auto arcs = shown.arcs.arcs(sample, camera, arcs_pane);
      for (const TorqueArcs::Arc& arc : arcs) {
        const double torque = arc.is_further ? further : -back;
        EXPECT_NEAR(length_on_screen(arc, camera), shown.arcs.scale() * torque * pixels, 0.1)
            << scene.name;
      }
      const double difference = shown.arcs.scale() * (further + back) * pixels;
      if (arcs.size() < 2 || std::abs(difference) < 0.2) return;
      ++compared;
      EXPECT_EQ(length_on_screen(arcs[0], camera) > length_on_screen(arcs[1], camera),
                further > -back)
          << scene.name;
    });
  }
  EXPECT_GT(compared, 300);
}

TEST(TorqueArcs, TurnAboutTheAxisOfTheTiltInTheDirectionsOfTheTorques) {
  for (const scene::Scene& scene : rigid_scenes()) {
    const Shown shown(scene);
    shown.for_each([&](const motion::Sample& sample, const Camera& camera) {
      const Vector3d about = sample.X * shown.torque.axes(sample).about;
      for (const auto& [path, color, is_further] : shown.arcs.arcs(sample, camera, arcs_pane)) {
        for (std::size_t i = 1; i < path.size(); ++i) {
          EXPECT_NEAR(about.dot(path[i]), 0, 1e-9 * shown.radius);
          EXPECT_EQ(about.dot(path[i - 1].cross(path[i])) > 0, is_further);
        }
      }
    });
  }
}

TEST(TorqueArcs, LookTheSameAtEverySize) {
  std::vector<std::size_t> points;
  for (const double size : {1e-6, 1.0, 1e6}) {
    scene::Scene scene = t_wrench();
    scene.camera.frame = scene::Frame::rotating;
    for (body::Part& part : scene.body.parts) {
      auto& rod = std::get<body::Cylinder>(part.shape);
      rod.radius *= size;
      rod.length *= size;
      part.position *= size;
    }
    const Shown shown(scene);
    std::size_t count = 0;
    shown.for_each([&](const motion::Sample& sample, const Camera& camera) {
      for (const auto& arc : shown.arcs.arcs(sample, camera, arcs_pane)) count += arc.path.size();
    });
    points.push_back(count);
  }
  EXPECT_GT(points[0], 100U);
  EXPECT_EQ(points, std::vector(3, points[0]));
}

TEST(TorqueArcs, StartAtTheEndOfTheLeg) {
  scene::Scene scene = t_wrench();
  for (const double spin : {1, -1}) {
    scene.motion.omega = spin * Vector3d(1, 0.05, 0);
    EXPECT_EQ(Shown(scene).torque.longer_end(), Vector3d::UnitX());
  }
}

TEST(TorqueArcs, AreNotDrawnWithoutATorque) {
  for (const Vector3d& omega : {Vector3d(0, 0, 0), {1, 0, 0}, {0, -1, 0}}) {
    scene::Scene scene = t_wrench();
    scene.motion.omega = omega;
    const Shown shown(scene);
    EXPECT_EQ(shown.arcs.scale(), 0);
    shown.for_each([&](const motion::Sample& sample, const Camera& camera) {
      EXPECT_TRUE(shown.arcs.arcs(sample, camera, arcs_pane).empty());
      DrawList opaque, translucent;
      opaque.begin(camera, arcs_pane);
      translucent.begin(camera, arcs_pane);
      shown.arcs.draw(sample, camera, arcs_pane, opaque, translucent);
      EXPECT_TRUE(opaque.vertices().empty() && translucent.vertices().empty());
    });
  }
}

TEST(TorqueArcs, AreInTheViewOfTheBodyWithTheirNames) {
  scene::Scene scene = t_wrench();
  scene.camera.frame = scene::Frame::rotating;
  scene.body.descriptions = {{.name = "handle", .look = {}, .mesh = {}},
                             {.name = "leg", .look = {}, .mesh = {}}};
  scene.overlay.show = {scene::Feature::labels};
  const timeline::Timeline timeline(scene, {110});
  const auto view_of = [&] {
    return BodyView(scene, timeline.solutions(), 0, {arcs_pane, arcs_pane}, 5);
  };
  const ViewContents before = shown_by(view_of(), timeline.frame_state(0));
  EXPECT_TRUE(before.opaque.vertices().empty());
  scene.overlay.show.insert(scene::Feature::torques);
  const BodyView view = view_of();
  const ViewContents contents = shown_by(view, timeline.frame_state(0));
  EXPECT_GT(contents.opaque.vertices().size(), 1000U);
  ASSERT_EQ(contents.labels.size(), 2U);
  EXPECT_EQ(contents.labels[0].text, "leg");
  EXPECT_EQ(contents.labels[1].text, "handle");
  for (const DrawList::Vertex& vertex : contents.opaque.vertices()) {
    EXPECT_LT(std::abs(vertex.clip.x), vertex.clip.w) << "the camera keeps it in view";
    EXPECT_LT(std::abs(vertex.clip.y), vertex.clip.w);
  }
}

}  // namespace
}  // namespace twrench::picture
