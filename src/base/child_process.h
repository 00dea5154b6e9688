#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"

namespace twrench {

/// A program that runs beside this one and is fed through a pipe. No shell is in between.
///
/// It is in a process group of its own, so that a Ctrl-C at the terminal is for this program alone,
/// which then decides what becomes of its child. For use by one thread.
class ChildProcess {
 public:
  /// Starts `command[0]`, looked for in PATH, with the rest as its arguments; its standard output
  /// is dropped. Throws std::system_error when it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command);

  /// Kills the child if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes to the child's standard input, waiting until it has taken all. False when it takes no
  /// more, which mostly means that it died. Raises no SIGPIPE.
  bool write(std::span<const std::uint8_t> bytes);

  /// Closes the child's standard input, waits for its end, and returns its exit status as a shell
  /// does: 0 to 255, 128 + n when signal n ended it.
  int wait();

  /// The last of what it wrote to standard error, up to 8 KiB.
  const std::string& error_output() const { return error_output_; }

 private:
  void read_errors();

  Descriptor input_;   ///< to its standard input; does not block
  Descriptor errors_;  ///< from its standard error; none after its end
  pid_t pid_ = -1;     ///< -1 once it is reaped
  int status_ = 0;
  std::string error_output_;
};

/// The last lines of what a program said, as one line for an error message.
std::string last_words(std::string_view output);

/// The command as it can be pasted into a POSIX shell.
std::string shell_command(std::span<const std::string> command);

}  // namespace twrench
