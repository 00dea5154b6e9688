#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "robot/compiled.h"
#include "robot/samples.h"

// Compares the bodies of MJCF files with those that MuJoCo itself compiles.
// scripts/maintain/mujoco.sh computed its values.

namespace twrench::robot {
namespace {

using Json = nlohmann::json;

const std::filesystem::path mjcf_folder = std::filesystem::path(TWRENCH_TESTS_DIR) / "robot/mjcf";

Json reference() { return Json::parse(std::ifstream(mjcf_folder / "reference.json")); }

/// A body of MuJoCo, which states its principal moments and axes.
LinkMass body_of(const Json& values) {
  const auto at = [](const Json& numbers, int i) { return numbers.at(i).get<double>(); };
  const Json &p = values.at("ipos"), &q = values.at("iquat"), &moments = values.at("inertia");
  const Eigen::Matrix3d axes =
      Eigen::Quaterniond(at(q, 0), at(q, 1), at(q, 2), at(q, 3)).toRotationMatrix();
  const Eigen::Vector3d diagonal(at(moments, 0), at(moments, 1), at(moments, 2));
  return {values.at("mass").get<double>(),
          {at(p, 0), at(p, 1), at(p, 2)},
          axes * diagonal.asDiagonal() * axes.transpose()};
}

/// The greatest error, relative to the mass, the size of the body and its greatest moment.
double difference_of(const LinkMass& ours, const LinkMass& theirs) {
  const double size = 1.0 + theirs.centre.norm();
  const double moment = theirs.inertia.cwiseAbs().maxCoeff();
  const double of_inertia = (ours.inertia - theirs.inertia).cwiseAbs().maxCoeff();
  return std::max({std::abs(ours.mass - theirs.mass) / std::max(theirs.mass, 1e-300),
                   (ours.centre - theirs.centre).norm() / size,
                   of_inertia == 0.0 ? 0.0 : of_inertia / moment});
}

TEST(MuJoCo, CompilesTheSameBodies) {
  const Json files = reference().at("files");
  ASSERT_GE(files.size(), 20U);
  for (const auto& [name, bodies] : files.items()) {
    const Robot robot = read_robot(mjcf_folder / name);
    Meshes meshes(robot, {});
    std::vector<LinkGeometry> geometries;
    for (const Link& link : robot.links) geometries.emplace_back(link, meshes);
    const auto compiled_bodies = compiled(robot, geometries);
    ASSERT_EQ(robot.links.size(), bodies.size()) << name;
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      const std::string what = name + ", " + robot.links[i].name;
      ASSERT_TRUE(compiled_bodies[i]) << what;
      const LinkMass theirs = body_of(bodies.at(robot.links[i].name));
      EXPECT_LE(difference_of(*compiled_bodies[i], theirs), 1e-13) << what;
    }
  }
}

}  // namespace
}  // namespace twrench::robot
