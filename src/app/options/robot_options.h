#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "robot/diagnosis.h"
#include "robot/geometry.h"
#include "robot/robot.h"
#include "scene/scene.h"

namespace twrench::app {

/// A robot with the geometries of its links and the judgement on them.
struct JudgedLinks {
  robot::Robot robot;
  std::vector<robot::LinkGeometry> geometries;
  std::vector<robot::Diagnosis> diagnoses;
  /// The meshes, and the robot's other files.
  std::vector<std::filesystem::path> files;
  /// What was not read, one line each.
  std::vector<std::string> notes;

  /// Returns the index of a link. Throws InvalidArgument about --link.
  std::size_t index(const std::string& link) const;
};

/// The options for a robot description: which link, and where its meshes are. Must live as long as
/// the command.
class RobotOptions {
 public:
  explicit RobotOptions(CLI::App& command);

  /// Throws InvalidArgument if one of the options is given; they have no meaning for a scene.
  void require_none() const;

  /// Returns the options that were given, as words of a command line.
  std::vector<std::string> given() const;

  /// Returns the name of the link; empty if it was not given.
  const std::string& link() const { return link_; }

  /// Reads a robot description and judges its links. Throws as robot::read_robot().
  JudgedLinks read(const std::string& file) const;

  /// Returns the scene of the link, which moves by the inertia of the file and is drawn as its
  /// geometry. Throws InvalidArgument about --link, also if its mass properties are not stated.
  scene::Scene scene(const JudgedLinks& judged) const;

 private:
  CLI::App& command_;
  std::string link_;
  std::vector<std::string> packages_;
};

}  // namespace twrench::app
