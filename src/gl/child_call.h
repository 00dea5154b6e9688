#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace twrench::gl {

/// A call in a child process, so that a crash of an OpenGL driver does not end this process.
class ChildCall {
 public:
  /// Starts the child, a copy of this process with one thread, which prints nothing. The text that
  /// `call` returns must have no control characters except line ends.
  explicit ChildCall(const std::function<std::string()>& call);

  /// Kills the child if it is still running.
  ~ChildCall();
  ChildCall(const ChildCall&) = delete;
  ChildCall& operator=(const ChildCall&) = delete;

  /// Waits for the call and returns its result. Does not wait for the end of the child, which takes
  /// some milliseconds more. Call this once. Throws the GlError of the call, or a GlError with a
  /// remedy if the call crashed or took longer than a minute.
  std::string result();

 private:
  /// Reads the answer of the child. Throws GlError if it ends without one.
  std::string read_all();
  /// Returns the wait status of the child.
  int reap();

  pid_t child_ = -1;
  int pipe_ = -1;  ///< From the child.
};

}  // namespace twrench::gl
