#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "robot/diagnosis.h"

namespace twrench::app {

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
  robot::JudgedRobot read(const std::string& file) const;

  /// Returns the index of the link. Throws InvalidArgument about --link, also if it is not given.
  std::size_t index(const robot::Robot& robot) const;

 private:
  CLI::App& command_;
  std::string link_;
  std::vector<std::string> packages_;
};

/// Writes the first notes on a robot as warnings, and the number of the others.
void warn_of_notes(const robot::JudgedRobot& judged);

}  // namespace twrench::app
