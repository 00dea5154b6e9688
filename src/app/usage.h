#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "base/error.h"

namespace twrench {

/// The words of a command line as CLI11 takes them, the last first. "--name=" becomes "--name" and
/// an empty word: some releases of CLI11 would take the next word for the value.
std::vector<std::string> words_for_parser(int argc, const char* const* argv);

/// Makes an empty value, which a script has from a variable that is not set, a mistake of the
/// command line: to be called when all options are there. A title may be empty.
void refuse_empty_values(CLI::App& app);

/// What is wrong with the command line that `app` could not parse, in our words, whatever release
/// of CLI11 complains; with the nearest option offered for one that there is not.
UsageError usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace twrench
