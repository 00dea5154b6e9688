#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace twrench {

/// What is said when a signal ends the program.
struct TerminationMessage {
  std::string error;   ///< "interrupted by SIGINT", to which an action may add details
  std::string remedy;  ///< may be empty
};

/// An action that is taken when a signal ends the process while this lives, for then no destructor
/// runs: a temporary file is to be removed, a child process to be killed. A process has one list of
/// them, as it has one disposition of each signal. The last one made is taken first.
class TerminationAction {
 public:
  using Action = std::function<void(TerminationMessage&)>;

  /// The action runs on another thread, while hold_termination() is held. What it throws is
  /// dropped.
  explicit TerminationAction(Action action);
  ~TerminationAction();
  TerminationAction(const TerminationAction&) = delete;
  TerminationAction& operator=(const TerminationAction&) = delete;

 private:
  const Action action_;
};

/// While it is held no signal ends the process: to make or to give up a resource together with its
/// TerminationAction. A thread may hold it more than once, and not for long.
[[nodiscard]] std::unique_lock<std::recursive_mutex> hold_termination();

/// Takes the actions, and for good keeps others from making or giving up resources: to be called
/// just before the process ends in a way in which no destructor runs.
void take_termination_actions(TerminationMessage& message);

/// From now on SIGINT, SIGTERM, SIGHUP and SIGXCPU, but for those that the parent has told us to
/// ignore, end the process at once, whatever it waits for: the actions are taken, `report` is
/// called, and the process exits with 130 after SIGINT and 143 after the others. To be called once,
/// before any thread is started: threads inherit what signals are blocked.
void end_on_termination_signals(std::function<void(const TerminationMessage&)> report);

}  // namespace twrench
