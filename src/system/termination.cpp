#include "system/termination.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <exception>
#include <list>
#include <system_error>
#include <thread>
#include <utility>

namespace twrench::system {
namespace {

struct Registry {
  std::recursive_mutex mutex;
  std::list<const TerminationAction::Action*> actions;
};

/// Never destroyed, because the signal thread may use it during process exit; and not allocated,
/// because it is needed when memory has run out.
union Immortal {
  Immortal() : registry() {}
  ~Immortal() {}  // NOLINT(modernize-use-equals-default): that would be deleted
  Registry registry;
};

Registry& registry() {
  static Immortal only;
  return only.registry;
}

constexpr std::array<std::pair<int, const char*>, 4> ending_signals{
    {{SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}, {SIGXCPU, "SIGXCPU"}}};

/// Returns the signals that are not ignored: nohup, or a shell's `&`, ignores some for its
/// children.
sigset_t heeded_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const auto& [signal, name] : ending_signals) {
    struct sigaction disposition {};
    ::sigaction(signal, nullptr, &disposition);
    if (disposition.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

TerminationMessage message_of(int arrived) {
  for (const auto& [signal, name] : ending_signals) {
    if (signal == arrived) return {arrived, std::string("interrupted by ") + name, {}};
  }
  return {arrived, "interrupted", {}};
}

[[noreturn]] void end(int signal, const std::function<int(const TerminationMessage&)>& report) {
  TerminationMessage message = message_of(signal);
  run_termination_actions(message);
  ::_exit(report(message));
}

}  // namespace

TerminationAction::TerminationAction(Action action) : action_(std::move(action)) {
  const auto hold = hold_termination();
  registry().actions.push_back(&action_);
}

TerminationAction::~TerminationAction() {
  const auto hold = hold_termination();
  registry().actions.remove(&action_);
}

std::unique_lock<std::recursive_mutex> hold_termination() {
  return std::unique_lock(registry().mutex);
}

void run_termination_actions(TerminationMessage& message) {
  registry().mutex.lock();  // never unlocked
  auto& actions = registry().actions;
  while (!actions.empty()) {
    const TerminationAction::Action* const action = actions.back();
    actions.pop_back();
    try {
      (*action)(message);
    } catch (...) {  // NOLINT(bugprone-empty-catch): the other actions must still run
    }
  }
}

void end_on_termination_signals(std::function<int(const TerminationMessage&)> report) {
  const sigset_t signals = heeded_signals();
  sigset_t before;
  pthread_sigmask(SIG_BLOCK, &signals, &before);
  try {
    std::thread([signals, report = std::move(report)] {
      int arrived = 0;
      while (sigwait(&signals, &arrived) != 0) {
      }
      end(arrived, report);
    }).detach();
  } catch (
      const std::system_error&) {  // without a thread, signals end the process in the default way
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
}

}  // namespace twrench::system
