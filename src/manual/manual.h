#pragma once

#include <string>
#include <vector>

#include "app/options/command_model.h"

namespace twrench::manual {

/// The release that a page describes, for its footer.
struct Release {
  std::string version;
  /// The date, such as 2026-11-22.
  std::string date;
};

/// Returns twrench(1): the program, its commands and its exit codes.
std::string program_page(const app::Command& program, const std::vector<app::Command>& commands,
                         const Release& release);

/// Returns twrench-COMMAND(1).
std::string command_page(const app::Command& command, const Release& release);

/// Returns twrench-scene(5): the format of scene files, with every field of a scene; `example` is
/// the text of one.
std::string scene_page(const std::string& example, const Release& release);

// Each returns a script that completes commands, options and the values of options.

std::string bash_completion(const app::Command& program, const std::vector<app::Command>& commands);
std::string zsh_completion(const app::Command& program, const std::vector<app::Command>& commands);
std::string fish_completion(const app::Command& program, const std::vector<app::Command>& commands);

}  // namespace twrench::manual
