#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <thread>

#include "system/descriptor.h"

namespace twrench::system {

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
