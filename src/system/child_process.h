#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "system/descriptor.h"
#include "system/termination.h"

namespace twrench::system {

/// How long to wait for a child process that accepts no data or does not exit, before it is killed.
/// Messages that it prints do not prolong the wait.
struct Patience {
  /// The time after which it is considered hung. Time during which this program itself is stopped
  /// does not count.
  std::chrono::milliseconds time = std::chrono::seconds(60);
  /// Ends the patience at once when another thread sets it to true; may be null.
  const std::atomic<bool>* stop = nullptr;
};

/// A child process that is fed through a pipe, started without a shell.
///
/// It has its own process group, so that Ctrl-C at the terminal reaches only this program, which
/// then decides what happens to the child. Not thread-safe.
class ChildProcess {
 public:
  using Time = std::chrono::milliseconds;

  /// Discards a child's standard output, which otherwise goes to one of our descriptors.
  static constexpr int output_dropped = -1;

  /// Starts `command[0]`, searched in PATH, with the rest as its arguments. Throws
  /// std::system_error if it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& command, Patience patience = {},
                        int output = output_dropped);

  /// Kills the child if it is still running. A signal that ends this process also kills it.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes to the child's standard input and waits until all is accepted. Returns false if the
  /// child accepts no more, usually because it died; a child that exhausts the patience is killed.
  /// Raises no SIGPIPE.
  bool write(std::span<const std::uint8_t> bytes);

  /// Like write(), but the pipe references the bytes instead of copying them. They must stay
  /// unchanged until another pipe_size() bytes have been accepted or the child has ended, by when
  /// they have been read.
  bool lend(std::span<const std::uint8_t> bytes);

  /// Returns the maximum number of accepted bytes that the child has not yet read.
  std::size_t pipe_size() const;

  /// Closes the child's standard input, waits for it to exit, and returns its exit status as a
  /// shell does: 0 to 255, or 128 + n if signal n ended it. Kills the child if it takes longer than
  /// its patience plus `work_left`, which allows for work that it is known to have left.
  int wait(Time work_left = {});

  /// Returns whether it was killed because it exhausted the patience.
  bool timed_out() const { return timed_out_; }

  /// Returns how long it made no progress before it was killed, if timed_out().
  Time time_waited() const { return time_waited_; }

  /// Returns the end of its standard error output, up to 8 KiB.
  const std::string& error_output() const { return error_output_; }

 private:
  using Put = ssize_t (*)(int pipe, std::span<const std::uint8_t> bytes);

  bool send(std::span<const std::uint8_t> bytes, Put put);
  /// Returns the number of bytes read.
  int read_errors();
  void kill_unresponsive(Time waited);
  /// Checks without waiting. If it has ended, its process number may be reused by the system.
  bool has_ended();

  Patience patience_;
  bool timed_out_ = false;
  Time time_waited_{};
  Descriptor input_;   ///< To its standard input; non-blocking.
  Descriptor errors_;  ///< From its standard error; none after its end.
  pid_t pid_ = -1;     ///< -1 once it has been reaped.
  int status_ = 0;
  std::string error_output_;
  std::optional<TerminationAction> kill_;  ///< Until it has been reaped.
};

/// A pipe for the output of a child process, which is read on its own thread while the child works.
class OutputPipe {
 public:
  /// Receives the bytes piece by piece, on the thread of the pipe. Must not throw.
  using Receive = std::function<void(std::span<const std::uint8_t>)>;

  /// Throws std::system_error.
  explicit OutputPipe(Receive receive);
  ~OutputPipe() { finish(); }
  OutputPipe(const OutputPipe&) = delete;
  OutputPipe& operator=(const OutputPipe&) = delete;

  /// Returns the end that the child writes to.
  int descriptor() const { return write_end_.get(); }

  /// Waits until all output of the child, which must have ended, was received.
  void finish();

 private:
  void read_all();

  Receive receive_;
  Descriptor read_end_, write_end_;
  std::atomic<bool> has_ended_ = false;
  std::thread reader_;
};

}  // namespace twrench::system
