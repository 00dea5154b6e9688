#pragma once

#include <string>

#include "app/options/arguments.h"
#include "app/options/robot_options.h"
#include "app/terminal/error_report.h"

namespace twrench::app {

/// The options of `inertia` that judge and repair all links of a robot.
struct RepairOptions {
  std::string fixed_file, page;
  bool from_mesh = false;
};

/// Adds --fix, --report and --from-mesh.
void add_repair_options(CLI::App& command, RepairOptions& options);

/// Prints the judgement on each link, and writes the page and the repaired file if they are
/// wanted. Returns
/// ExitCode::negative if a link is impossible.
ExitCode judge_robot(const std::string& file, const RobotOptions& robot_options,
                     const RepairOptions& repair_options, const OutputOptions& output);

}  // namespace twrench::app
