#pragma once

#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "system/child_process.h"

// Starts external programs, and describes them in messages.

namespace twrench::system {

/// Returns why a program could not be started, for example "it was not found in PATH".
std::string why_not_started(const std::system_error& error);

/// Returns what the user can do about it; `installation` if the program is missing.
std::string remedy_for_start(const std::system_error& error, const std::string& installation);

/// Starts the program. Throws `Failure` with a remedy if it cannot be started; if it is missing,
/// the remedy is `installation`.
template <typename Failure>
ChildProcess start_program(const std::vector<std::string>& command, const std::string& installation,
                           Patience patience = {}, int output = ChildProcess::output_dropped) {
  try {
    return ChildProcess(command, patience, output);
  } catch (const std::system_error& error) {
    throw Failure("cannot start " + command.front(), why_not_started(error),
                  remedy_for_start(error, installation));
  }
}

/// Returns the last lines of a program's output as one line for an error message.
std::string error_summary(std::string_view output);

/// Returns how a program failed that has ended, for an error message. `program` is its name. If it
/// reported success, it ended before it had read its input.
std::string failure_of(const std::string& program, const ChildProcess& child, int status);

/// Returns the command in a form that can be pasted into a POSIX shell.
std::string shell_command(std::span<const std::string> command);

}  // namespace twrench::system
