#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/descriptor.h"
#include "base/termination.h"

namespace twrench {

/// A program that runs beside this one and is fed through a pipe. No shell is in between.
///
/// It is in a process group of its own, so that a Ctrl-C at the terminal is for this program alone,
/// which then decides what becomes of its child. For use by one thread.
class ChildProcess {
 public:
  using Time = std::chrono::milliseconds;

  /// After which a child that takes nothing, or does not end, is taken to hang. The time in which
  /// this program is itself stopped is not counted.
  static constexpr Time default_patience = std::chrono::seconds(60);

  /// Where a child's standard output goes, if not to a descriptor of ours.
  static constexpr int output_dropped = -1;
  static constexpr int output_with_errors = STDERR_FILENO;  ///< into error_output()

  /// Starts `command[0]`, looked for in PATH, with the rest as its arguments. Throws
  /// std::system_error when it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command, Time patience = default_patience,
                        int output = output_dropped);

  /// Kills the child if it still runs. So does a signal that ends this process.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes to the child's standard input, waiting until it has taken all. False when it takes no
  /// more, which mostly means that it died; or it hangs, and was killed. Raises no SIGPIPE.
  bool write(std::span<const std::uint8_t> bytes);

  /// As write(), but the bytes are lent to the pipe and not copied into it. They are to stay as
  /// they are until pipe_size() bytes more were taken, or the child has ended: then they have been
  /// read.
  bool lend(std::span<const std::uint8_t> bytes);

  /// How many bytes may have been taken that the child has not yet read.
  std::size_t pipe_size() const;

  /// Closes the child's standard input, waits for its end, and returns its exit status as a shell
  /// does: 0 to 255, 128 + n when signal n ended it. Kills it when it takes longer than its
  /// patience and this, which is for work that it is known to have left.
  int wait(Time work_left = {});

  /// Whether it was killed because it hung.
  bool hung() const { return hung_; }

  /// The last of what it wrote to standard error, up to 8 KiB.
  const std::string& error_output() const { return error_output_; }

 private:
  using Put = ssize_t (*)(int pipe, std::span<const std::uint8_t> bytes);

  bool send(std::span<const std::uint8_t> bytes, Put put);
  void read_errors();
  void give_up();
  /// Asks, without waiting; its number is the system's again when it has.
  bool has_ended();

  Time patience_;
  bool hung_ = false;
  Descriptor input_;   ///< to its standard input; does not block
  Descriptor errors_;  ///< from its standard error; none after its end
  pid_t pid_ = -1;     ///< -1 once it is reaped
  int status_ = 0;
  std::string error_output_;
  std::optional<TerminationAction> kill_;  ///< until it is reaped
};

/// Why a program could not be started, in words: "it was not found in PATH".
std::string why_not_started(const std::system_error& error);

/// What a user can do about it; `installation` where the program is missing.
std::string remedy_for_start(const std::system_error& error, const std::string& installation);

/// The program, running. Throws `Failure` when it cannot be started, with the remedy:
/// `installation` where it is missing.
template <typename Failure>
ChildProcess start_program(const std::vector<std::string>& command, const std::string& installation,
                           ChildProcess::Time patience = ChildProcess::default_patience,
                           int output = ChildProcess::output_dropped) {
  try {
    return ChildProcess(command, patience, output);
  } catch (const std::system_error& error) {
    throw Failure("cannot start " + command.front(), why_not_started(error),
                  remedy_for_start(error, installation));
  }
}

/// The last lines of what a program said, as one line for an error message.
std::string last_words(std::string_view output);

/// The command as it can be pasted into a POSIX shell.
std::string shell_command(std::span<const std::string> command);

}  // namespace twrench
