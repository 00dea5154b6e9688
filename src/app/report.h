#pragma once

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/termination.h"

namespace twrench {

/// Prints what is being thrown on standard error, as "twrench: error: WHAT: WHY" with the remedy on
/// a second line, and returns its exit code. To be called in a catch clause. `app` tells which
/// command was running.
ExitCode report_current_exception(const CLI::App& app);

/// Prints, in the same way, that a signal ends the program.
void report_termination(const TerminationMessage& message);

}  // namespace twrench
