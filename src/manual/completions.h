#pragma once

#include <string>
#include <vector>

#include "app/options/command_model.h"

namespace twrench::manual {

// Each returns a script that completes commands, options and the values of options.

std::string bash_completion(const app::Command& program, const std::vector<app::Command>& commands);
std::string zsh_completion(const app::Command& program, const std::vector<app::Command>& commands);
std::string fish_completion(const app::Command& program, const std::vector<app::Command>& commands);

}  // namespace twrench::manual
