#include "app/options/robot_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "app/options/arguments.h"
#include "app/terminal/message.h"
#include "base/words.h"

namespace twrench::app {
namespace {

constexpr std::array robot_option_names{"--link", "--package-path"};

}  // namespace

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

robot::JudgedRobot RobotOptions::read(const std::string& file) const {
  return robot::judge_robot(robot::read_robot(file), {packages_.begin(), packages_.end()});
}

std::size_t RobotOptions::index(const robot::Robot& robot) const {
  if (!link_.empty()) return robot.index(link_, "--link");
  std::vector<std::string> names;
  for (const robot::Link& link : robot.links) names.push_back(link.name);
  throw InvalidArgument(robot.file.string(), "it has several links, and one of them is the body",
                        fmt::format("--link NAME, which is one of {}", fmt::join(names, ", ")));
}

void warn_of_notes(const robot::JudgedRobot& judged) {
  constexpr std::size_t most = 20;
  const std::vector<std::string>& notes = judged.notes;
  for (std::size_t i = 0; i < std::min(most, notes.size()); ++i)
    warn(with_arguments(notes[i], option_text));
  if (notes.size() > most) {
    warn(fmt::format("{}: {} other notes are not shown; see them all with inertia --format json",
                     judged.robot.file.string(), notes.size() - most));
  }
}

}  // namespace twrench::app
