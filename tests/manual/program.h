#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/options/command_model.h"
#include "system/file.h"

namespace twrench::manual {

using app::Command;
using app::Option;

/// The commands of the program, with names without the leading "twrench".
inline std::vector<Command> all_commands() { return app::program_model().commands; }

/// The text of a file that the build wrote.
inline std::string written(const std::string& name) {
  constexpr std::size_t longest = 1 << 20;
  const auto bytes = system::read_file(std::filesystem::path(TWRENCH_MANUAL) / name, longest);
  return {bytes.begin(), bytes.end()};
}

}  // namespace twrench::manual
