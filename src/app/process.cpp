#include "app/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
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

void write_error(std::string_view text) {
  static_cast<void>(::write(STDERR_FILENO, text.data(), text.size()) < 0);  // nobody may listen
}

/// Compiled code that may not throw calls std::terminate without telling it of the exception.
std::atomic<bool> memory_ran_out = false;

void note_lack_of_memory() {
  memory_ran_out = true;
  throw std::bad_alloc();
}

void write_lack_of_memory() {
  write_error(
      "memory: out of memory\n"
      "  close other programs, or raise the limit on memory (ulimit -v)\n");
}

/// What could not be thrown to main(), if anything was.
void write_reason() {
  try {
    if (std::current_exception()) throw;
    if (memory_ran_out) return write_lack_of_memory();
    write_error("internal: std::terminate without an exception\n");
  } catch (const std::bad_alloc&) {
    write_lack_of_memory();
  } catch (const std::exception& error) {
    write_error("internal: ");
    write_error(error.what());
    write_error("\n");
  } catch (...) {
    write_error("internal: an exception of unknown type\n");
  }
}

/// Before the libraries make their static objects, which also takes memory.
[[gnu::constructor(101)]] void handle_terminate() {
  std::set_terminate(&end_at_once);
  std::set_new_handler(&note_lack_of_memory);
}

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
  TerminationMessage unused;
  take_termination_actions(unused);
  write_error("twrench: error: ");
  write_reason();
  ::_exit(static_cast<int>(ExitCode::internal));
}

}  // namespace twrench
