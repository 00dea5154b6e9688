#include "app/options/robot_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "app/options/arguments.h"
#include "base/words.h"
#include "robot/report.h"
#include "scene/limits.h"
#include "scene/mesh_scene.h"

namespace twrench::app {
namespace {

constexpr std::array robot_option_names{"--link", "--package-path"};

std::vector<std::string> link_names(const robot::Robot& robot) {
  std::vector<std::string> names;
  for (const robot::Link& link : robot.links) names.push_back(link.name);
  return names;
}

/// The parts of a link about its centre of mass.
std::vector<body::Part> drawn_parts(const robot::LinkGeometry& geometry,
                                    const robot::LinkMass& body) {
  constexpr double cm_per_m = 100.0;
  std::vector<body::Part> parts = geometry.parts();
  for (body::Part& part : parts) part.position -= cm_per_m * body.centre;
  return parts;
}

}  // namespace

std::size_t JudgedLinks::index(const std::string& link) const {
  const std::vector<std::string> names = link_names(robot);
  const auto found = std::ranges::find(names, link);
  if (found == names.end()) throw unknown_name("--link", link, names);
  return static_cast<std::size_t>(found - names.begin());
}

RobotOptions::RobotOptions(CLI::App& command) : command_(command) {
  command.add_option("--link", link_, "of a robot description: the link that is the body")
      ->type_name("NAME")
      ->group(heading(OptionGroup::body));
  command
      .add_option("--package-path", packages_,
                  "of a robot description: a folder that contains its packages or models; can be "
                  "repeated")
      ->type_name("DIR")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->default_str("the folders above the file")
      ->group(heading(OptionGroup::body));
}

void RobotOptions::require_none() const {
  for (const char* option : robot_option_names) {
    if (command_.count(option) == 0) continue;
    throw InvalidArgument(option, "is for a robot description, and this is none",
                          "name a file in URDF, SDF or MJCF that ends in .urdf, .sdf or .xml");
  }
}

std::vector<std::string> RobotOptions::given() const {
  return given_options(command_, {robot_option_names.begin(), robot_option_names.end()});
}

JudgedLinks RobotOptions::read(const std::string& file) const {
  JudgedLinks judged;
  judged.robot = robot::read_robot(file);
  judged.notes = judged.robot.notes;
  robot::Meshes meshes(judged.robot, {packages_.begin(), packages_.end()});
  for (const robot::Link& link : judged.robot.links) {
    judged.geometries.emplace_back(link, meshes);
    for (const std::string& problem : judged.geometries.back().problems())
      judged.notes.push_back(fmt::format("link '{}': {}", link.name, problem));
  }
  judged.diagnoses = robot::diagnose(judged.robot, judged.geometries);
  judged.files = meshes.files();
  judged.files.insert(judged.files.end(), judged.robot.others.begin(), judged.robot.others.end());
  return judged;
}

scene::Scene RobotOptions::scene(const JudgedLinks& judged) const {
  const std::string file = judged.robot.file.string();
  if (link_.empty()) {
    throw InvalidArgument(
        file, "it has several links, and one of them is the body",
        fmt::format("--link NAME, which is one of {}", fmt::join(link_names(judged.robot), ", ")));
  }
  const std::size_t index = judged.index(link_);
  const robot::Diagnosis& diagnosis = judged.diagnoses[index];
  const std::string what = fmt::format("{}: link '{}'", file, link_);
  if (diagnosis.verdict == robot::Verdict::unstated) {
    throw InvalidArgument(what, "the file states no mass properties for it",
                          "choose a link that has an <inertial>");
  }
  if (!(diagnosis.moments[0] > 0.0)) {
    throw InvalidArgument(what, diagnosis.faults.front().text,
                          "repair it first: twrench inertia FILE --fix OUT");
  }
  constexpr double g_cm2_per_kg_m2 = 1e7;
  scene::Body body;
  body.inertia =
      scene::limits::check_inertia(what.c_str(), g_cm2_per_kg_m2 * diagnosis.body.inertia);
  body.parts = drawn_parts(judged.geometries[index], diagnosis.body);
  return scene::body_scene(link_, std::move(body));
}

}  // namespace twrench::app
