#pragma once

#include <twrench/base/error.h>

#include "app/terminal/exit_code.h"
#include "system/termination.h"

namespace twrench::app {

/// Returns the remedy on the command line: the error's own or, if an option helps, one that names
/// the option; may be empty.
std::string remedy_for(const Error& error);

/// Prints the exception being handled on standard error, as "twrench: error: WHAT: WHY" with the
/// remedy on a second line, and returns its exit code. Call it in a catch clause. `draws` is
/// whether the failed command draws frames, and so could use less memory.
ExitCode report_current_exception(bool draws);

/// Prints, in the same way, that a signal ends the program, and returns its exit code.
ExitCode report_termination(const system::TerminationMessage& message);

}  // namespace twrench::app
