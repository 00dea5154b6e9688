#pragma once

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/termination.h"

namespace twrench {

/// Prints the exception being handled on standard error, as "twrench: error: WHAT: WHY" with the
/// remedy on a second line, and returns its exit code. Call it in a catch clause. `app` tells which
/// command was running.
ExitCode report_current_exception(const CLI::App& app);

/// Reports in the same way that a signal ends the program.
void report_termination(const TerminationMessage& message);

}  // namespace twrench
