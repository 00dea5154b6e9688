#pragma once

#include <twrench/base/error.h>

#include <string>
#include <vector>

#include "app/options/command_line.h"

namespace twrench::app {

/// Returns the arguments as CLI11 takes them, the last first. "--name=" becomes "--name" and an
/// empty word, because some CLI11 releases would take the next word as its value.
std::vector<std::string> words_for_parser(int argc, const char* const* argv);

/// Makes an empty value, as a script passes it from an unset variable, a usage error. Call it when
/// all options have been added. A title may be empty.
void refuse_empty_values(CLI::App& app);

/// Returns our error message for a command line that `app` could not parse, independently of the
/// CLI11 release; suggests the nearest option for an unknown one.
InvalidArgument usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace twrench::app
