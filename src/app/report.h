#pragma once

#include <CLI/CLI.hpp>

#include "base/error.h"

namespace twrench {

/// Prints what is being thrown on standard error, as "twrench: error: WHAT: WHY" with the remedy on
/// a second line, and returns its exit code. To be called in a catch clause. `app` tells which
/// command was running.
ExitCode report_current_exception(const CLI::App& app);

}  // namespace twrench
