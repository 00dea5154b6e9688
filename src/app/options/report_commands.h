#pragma once

#include <string>
#include <vector>

#include "app/options/command_line.h"
#include "app/options/scene_options.h"
#include "report/results.h"

namespace twrench::app {

/// Returns the command line of `twrench report` with the given arguments, and with --static if
/// `is_static`.
std::string report_command_line(const CLI::App& command, const SceneOptions& scenes,
                                const std::string& output, bool is_static);

/// Returns the command lines for an experiment. `source` is its scene as an argument and, if it is
/// a mesh, the options of the mesh; `command` is that of the report, whose options apply to them.
report::Commands commands_of(const scene::Scene& scene, const std::vector<std::string>& source,
                             const CLI::App& command);

}  // namespace twrench::app
