#pragma once

#include <string>
#include <vector>

#include "manual/command_model.h"

namespace twrench::manual {

// Each returns a script that completes commands, options and the values of options.

std::string bash_completion(const Command& program, const std::vector<Command>& commands);
std::string zsh_completion(const Command& program, const std::vector<Command>& commands);
std::string fish_completion(const Command& program, const std::vector<Command>& commands);

}  // namespace twrench::manual
