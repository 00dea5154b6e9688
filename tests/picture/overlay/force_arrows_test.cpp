#include "picture/overlay/force_arrows.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "picture/body/bounding_radius.h"
#include "picture/t_wrench.h"

namespace twrench::picture {
namespace {

using Eigen::Vector3d;

scene::Scene in_frame(scene::Frame frame) {
  scene::Scene scene = t_wrench(64, 36);
  scene.camera.frame = frame;
  return scene;
}

ForceArrows arrows_of(const scene::Scene& scene, const timeline::Timeline& timeline) {
  return {scene, timeline.solutions()[0], bounding_radius(scene::visible_parts(scene.body))};
}

/// Returns the number of triangles of the arrows in a frame of the film.
std::size_t drawn_items(const scene::Scene& scene, int frame) {
  const timeline::Timeline timeline(scene, {frame});
  DrawList list;
  list.begin(frame_sphere({{1, 2, 5}, 0.6, 4.0 / 3, 10}), {0, 0, 640, 480});
  arrows_of(scene, timeline).draw(timeline.frame_state(0).solutions[0], list);
  return list.items().faces.size() / 3;
}

TEST(ForceArrows, StartAtTheEndsOfTheWrenchsRods) {
  const scene::Scene scene = in_frame(scene::Frame::rotating);
  const timeline::Timeline timeline(scene, {0});
  const auto points = arrows_of(scene, timeline).points();
  ASSERT_EQ(points.size(), 4U);
  for (const Vector3d& end :
       {Vector3d(-1, 4, 0), Vector3d(-1, -4, 0), Vector3d(4, 0, 0), Vector3d(0, 0, 0)}) {
    const auto is_there = [&](const ForceArrows::Point& p) {
      return (p.mass.position - end).norm() < 1e-9 && (p.start - end).norm() < 0.2;
    };
    EXPECT_TRUE(std::ranges::any_of(points, is_there)) << end.transpose();
  }
}

TEST(ForceArrows, TakeASmallBallForAPointAndADiscForFour) {
  scene::Scene scene = scene::load_scene("tao-disk");
  const timeline::Timeline timeline(scene, {0});
  const auto points = arrows_of(scene, timeline).points();
  ASSERT_EQ(points.size(), 4U + 4U);
  EXPECT_NEAR(points[4].mass.mass, 33.58, 0.01);
  EXPECT_EQ(points[4].mass.position, Vector3d(4, 0, 0));
  EXPECT_EQ(points[4].clearance, 0.75);
}

TEST(ForceArrows, HaveTheLengthsOfTheForces) {
  // In a steady rotation each point is pulled outwards and held: two arrows of one length.
  scene::Scene scene = in_frame(scene::Frame::rotating);
  scene.motion.omega = {1, 0, 0};
  const timeline::Timeline timeline(scene, {0});
  const ForceArrows arrows = arrows_of(scene, timeline);
  const double strongest =
      arrows.points()[0].mass.mass * 1 * 4;  // the ends of the handle, 4 cm away
  const double length = arrows.scale() * strongest;
  EXPECT_NEAR(length, 0.5 * bounding_radius(scene::visible_parts(scene.body)), 1e-9);
  double highest = 0;
  for (const Vector3d& tip : arrows.extent()) highest = std::max(highest, tip.y());
  EXPECT_NEAR(highest, 4 + length, 0.1) << "above the handle, which rests in the frame";
}

TEST(ForceArrows, ShowTheForcesThatThereAreInTheFrame) {
  const std::size_t space = drawn_items(in_frame(scene::Frame::space), 100);
  EXPECT_GT(space, 0U) << "what holds it";
  EXPECT_GT(drawn_items(in_frame(scene::Frame::body), 100), space);
  EXPECT_GT(drawn_items(in_frame(scene::Frame::rotating), 100), space);
  scene::Scene rest = in_frame(scene::Frame::body);
  rest.motion.omega = Vector3d::Zero();
  EXPECT_EQ(drawn_items(rest, 100), 0U);
}

TEST(Forces, OfAFrameAreThoseThatCanBeThere) {
  EXPECT_EQ(forces_in(scene::Frame::space), std::vector{Force::constraint});
  for (const scene::Frame frame : {scene::Frame::body, scene::Frame::rotating}) {
    EXPECT_EQ(forces_in(frame).size(), 3U);
  }
  EXPECT_EQ(name_of(Force::centrifugal).in(scene::Language::nb), "sentrifugal");
}

}  // namespace
}  // namespace twrench::picture
