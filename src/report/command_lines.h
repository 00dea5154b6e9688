#pragma once

#include <string>
#include <vector>

#include "report/results.h"

namespace twrench::report {

/// Returns a file's name as an argument that does not look like an option.
std::string argument_of(const std::string& name);

/// Returns the command lines for an experiment. `source` is its scene as an argument and, if it is
/// a mesh, the options of the mesh. The other options replace its body, and the rest of its motion.
Commands commands_of(const scene::Scene& scene, const std::vector<std::string>& source,
                     const std::vector<std::string>& body_options,
                     const std::vector<std::string>& motion_options);

/// Returns the command lines of the tasks that belong to no experiment.
TaskCommands task_commands();

}  // namespace twrench::report
