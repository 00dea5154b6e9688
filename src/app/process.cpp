#include "app/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <new>
#include <string_view>

#include "app/report.h"
#include "base/error.h"
#include "base/termination.h"

namespace twrench {
namespace {

/// Opens those of standard input, output and error that are closed, so that they fail as before: a
/// file that got one of their numbers would get what is meant for them.
void fill_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);  // gets the lowest free number
  }
}

std::string_view reason() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    return "memory: there is not enough of it\n"
           "  end other programs, or raise the limit on memory (ulimit -v)\n";
  } catch (...) {  // NOLINT(bugprone-empty-catch): a bug, as without any
  }
  return "internal: ended by std::terminate\n";
}

void write_error(std::string_view text) {
  static_cast<void>(::write(STDERR_FILENO, text.data(), text.size()) < 0);  // nobody may listen
}

/// Before the libraries make their static objects, which also takes memory.
[[gnu::constructor(101)]] void handle_terminate() { std::set_terminate(&end_at_once); }

}  // namespace

void prepare_process() {
  fill_standard_streams();
  // A reader that went away, and a file that may not grow, are errors to report, not a death.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  // Where the parent ignores it, nobody is told how a child ended.
  static_cast<void>(std::signal(SIGCHLD, SIG_DFL));
  end_on_termination_signals(&report_termination);
}

void end_at_once() noexcept {
  const std::string_view why = reason();
  TerminationMessage unused;
  take_termination_actions(unused);
  write_error("twrench: error: ");
  write_error(why);
  ::_exit(static_cast<int>(ExitCode::internal));
}

}  // namespace twrench
