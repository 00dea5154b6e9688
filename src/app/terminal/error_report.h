#pragma once

#include <twrench/base/error.h>

#include "app/terminal/exit_code.h"
#include "system/termination.h"

namespace twrench::app {

/// What a user of the command line can do about it: the error's own remedy or, where that takes an
/// option, which; may be empty.
std::string remedy_for(const Error& error);

/// Prints the exception being handled on standard error, as "twrench: error: WHAT: WHY" with the
/// remedy on a second line, and returns its exit code. Call it in a catch clause. `draws` says
/// whether the command that failed draws frames, and so could do with less memory.
ExitCode report_current_exception(bool draws);

/// Prints, in the same way, that a signal ends the program, and returns its exit code.
ExitCode report_termination(const system::TerminationMessage& message);

}  // namespace twrench::app
