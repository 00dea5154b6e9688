#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace twrench::system {

/// The error message when a signal ends the program.
struct TerminationMessage {
  int signal = 0;
  std::string error;   ///< "interrupted by SIGINT", to which an action may add details
  std::string remedy;  ///< May be empty.
};

/// An action to run if a signal ends the process during this object's lifetime, because destructors
/// do not run then: to remove a temporary file, to kill a child process. There is one list per
/// process, as there is one disposition per signal. The most recent action runs first.
class TerminationAction {
 public:
  using Action = std::function<void(TerminationMessage&)>;

  /// The action runs on another thread, which holds hold_termination(). Exceptions it throws are
  /// ignored.
  explicit TerminationAction(Action action);
  ~TerminationAction();
  TerminationAction(const TerminationAction&) = delete;
  TerminationAction& operator=(const TerminationAction&) = delete;

 private:
  const Action action_;
};

/// While this lock is held, no signal ends the process. Hold it, briefly, to create or release a
/// resource together with its TerminationAction. A thread may hold it more than once.
[[nodiscard]] std::unique_lock<std::recursive_mutex> hold_termination();

/// Runs the actions, and permanently prevents other threads from creating or releasing resources.
/// Call it just before the process ends without running destructors.
void run_termination_actions(TerminationMessage& message);

/// From now on, SIGINT, SIGTERM, SIGHUP and SIGXCPU end the process at once, whatever it waits for,
/// except those that the parent has set to be ignored. The actions run, `report` is called, and the
/// process exits with the status that `report` returns. Call this once, before any thread is
/// started, because threads inherit the set of blocked signals.
void end_on_termination_signals(std::function<int(const TerminationMessage&)> report);

}  // namespace twrench::system
