#pragma once

#include "base/error.h"
#include "base/termination.h"

namespace twrench {

/// Prints what is being thrown on standard error, as "twrench: error: WHAT: WHY" with the remedy on
/// a second line, and returns its exit code. To be called in a catch clause.
ExitCode report_current_exception();

/// Prints, in the same way, that a signal ends the program.
void report_termination(const TerminationMessage& message);

}  // namespace twrench
