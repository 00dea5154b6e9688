#pragma once

#include <csignal>
#include <optional>

namespace twrench {

/// While one lives, SIGINT and SIGTERM wait to be asked for instead of ending the program, so that
/// a run can end whole. Make it before any thread starts: threads inherit what they hold back.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The first of the signals that came, if one did; more may come, and change nothing.
  std::optional<int> arrived();

 private:
  sigset_t signals_{};
  sigset_t before_{};
  std::optional<int> first_;
};

}  // namespace twrench
