#include "picture/hud/captions.h"

#include <gtest/gtest.h>

#include "picture/overlay_scene.h"

namespace twrench::picture::captions {
namespace {

body::Part sphere(double radius, const Eigen::Vector3d& position) {
  return {body::Ellipsoid{Eigen::Vector3d::Constant(radius)}, 1, position,
          Eigen::Matrix3d::Identity()};
}

bool speaks_of_a_leg(const scene::Body& body) {
  return curve(body, "x", true, scene::Language::en).find("leg") != std::string::npos;
}

TEST(CurveCaption, SpeaksOfALegOnlyWhereThereIsOneAlongX) {
  scene::Body body = t_wrench().body;
  EXPECT_TRUE(speaks_of_a_leg(body));
  for (body::Part& part : body.parts) part.position += Eigen::Vector3d(5, 6, 7);
  EXPECT_TRUE(speaks_of_a_leg(body)) << "wherever the file places the body";
  body.parts[1].position.x() = -5;
  EXPECT_FALSE(speaks_of_a_leg(body)) << "it points the other way";
  body.parts = {body.parts[0]};
  EXPECT_FALSE(speaks_of_a_leg(body)) << "the handle alone";
}

TEST(CurveCaption, SpeaksOfNoLegForOtherBodies) {
  EXPECT_FALSE(speaks_of_a_leg({{}, Eigen::Vector3d(1, 2, 3).asDiagonal()}));
  EXPECT_FALSE(speaks_of_a_leg({{sphere(1, {0, 0, 0})}, {}}));
  EXPECT_FALSE(speaks_of_a_leg({{sphere(1, {4, 0, 0}), sphere(1, {-4, 0, 0})}, {}}));
  // With two legs, "the leg" would be ambiguous.
  const auto leg = [](double x) { return cylinder(0.5, 3, {x, 0, 0}, Eigen::Vector3d::UnitX()); };
  EXPECT_FALSE(speaks_of_a_leg({{sphere(1, {0, 0, 0}), leg(2), leg(-2)}, {}}));
  body::Part heavy = sphere(1, {0, 0, 0});
  heavy.density = 50;
  EXPECT_TRUE(speaks_of_a_leg({{heavy, leg(2)}, {}}));
}

Remark remark_at(const scene::Scene& scene, double t, double off_rotations = 0) {
  const OverlayScene film(scene);
  const timeline::Solution& solution = film.timeline.solutions()[0];
  timeline::SolutionState state;
  state.sample = motion::ExactMotion(solution.body).at(t);
  state.diagnostics.orthogonality_error = off_rotations;
  return Remarks(solution, scene.language).at(state);
}

TEST(Remarks, SayThatTheBodyTurnsOverAroundItsFlips) {
  const scene::Scene scene = t_wrench();
  for (const double flip : {11.815, 35.446, 59.077, 82.708}) {
    for (const double away : {-2.0, 0.0, 2.0}) {
      EXPECT_EQ(remark_at(scene, flip + away).text, "it turns over") << flip;
      EXPECT_EQ(remark_at(scene, flip + away).opacity, 1) << flip;
    }
    for (const double away : {-8.0, 8.0}) {
      EXPECT_EQ(remark_at(scene, flip + away).text, "") << flip;
    }
  }
  EXPECT_GT(remark_at(scene, 11.815 - 4.5).opacity, 0) << "it comes and goes";
  EXPECT_LT(remark_at(scene, 11.815 - 4.5).opacity, 1);
}

TEST(Remarks, AreInTheLanguageOfTheScene) {
  scene::Scene scene = t_wrench();
  scene.language = scene::Language::nb;
  EXPECT_EQ(remark_at(scene, 11.815).text, "den snur");
  EXPECT_EQ(remark_at(scene, 0, 0.02).text, "ikke lenger en rotasjon");
  EXPECT_EQ(curve(scene.body, "x", true, scene.language), "hvilken vei beinet peker");
  EXPECT_EQ(curve(scene.body, "y", true, scene.language), "legemets y-akse langs rommets y");
  EXPECT_EQ(curve(scene.body, "I2", false, scene.language),
            "legemets I2-akse langs sin første retning");
}

TEST(Remarks, SayNothingOfABodyThatDoesNotTurnOver) {
  scene::Scene scene = t_wrench();
  for (const Eigen::Vector3d& omega : {Eigen::Vector3d(0, 1, 0.05), {0.05, 0, 1}, {0, 0, 0}}) {
    scene.motion.omega = omega;
    for (double t = 0; t < 96; t += 7) EXPECT_EQ(remark_at(scene, t).text, "") << omega;
  }
}

TEST(Remarks, SayWhereTheMatrixIsNoRotation) {
  EXPECT_EQ(remark_at(t_wrench(), 0, 0.02).text, "no rotation any more");
  EXPECT_EQ(remark_at(t_wrench(), 11.8, 0.02).text, "no rotation any more") << "which matters more";
  EXPECT_EQ(remark_at(t_wrench(), 0, 1e-6).text, "");
}

}  // namespace
}  // namespace twrench::picture::captions
