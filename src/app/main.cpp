#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <exception>
#include <new>
#include <string_view>

#include "app/commands/commands.h"
#include "app/terminal/error_report.h"
#include "gl/context.h"
#include "gl/functions.h"
#include "system/termination.h"

namespace twrench::app {
namespace {

/// Opens closed standard streams in a way that still makes their use fail. Otherwise a file could
/// be given their descriptor and receive their data.
void fill_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);  // takes the lowest free descriptor
  }
}

void write_error(std::string_view text) {
  // Nothing can be done about a failure.
  static_cast<void>(::write(STDERR_FILENO, text.data(), text.size()) < 0);
}

/// Some compilers let noexcept functions call std::terminate without an active exception.
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

/// Writes the reason if an exception could not reach main().
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

/// Whether this process has used an OpenGL driver, or one that it was forked from.
bool may_be_the_drivers_fault() {
  try {
    return gl::has_used_opengl();
  } catch (const gl::GlError&) {
    return true;
  }
}

/// Prints a message when the program crashes. Calls only async-signal-safe functions, except in a
/// process that was forked from one that draws.
void report_crash(int) {
  write_error("twrench: error: internal: it crashed\n");
  write_error(may_be_the_drivers_fault()
                  ? "  the OpenGL driver may be at fault: see twrench doctor; or it had too little "
                    "memory (ulimit -v)\n"
                  : "  it may have had too little memory (ulimit -v)\n");
  ::_exit(static_cast<int>(ExitCode::internal));
}

/// Installs the crash handler, except where a tool such as a sanitizer has installed its own. The
/// handler has a separate stack, because the crash may be a stack overflow.
void handle_crashes() {
  static std::array<std::byte, 1 << 14> memory;
  stack_t stack{};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  ::sigaltstack(&stack, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) {
    struct sigaction action {};
    const bool is_free = ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL;
    action.sa_handler = &report_crash;
    action.sa_flags = SA_ONSTACK;
    if (is_free) ::sigaction(signal, &action, nullptr);
  }
}

/// Reports that memory ran out, or else that there is a bug, and ends the process with exit code 70
/// after removing its temporary files. For situations in which nothing can be thrown to main();
/// allocates no memory.
[[noreturn]] void end_at_once() noexcept {
  system::TerminationMessage unused;
  system::run_termination_actions(unused);
  write_error("twrench: error: ");
  write_reason();
  ::_exit(static_cast<int>(ExitCode::internal));
}

/// Runs before the libraries' static initialisers, which also allocate.
[[gnu::constructor(101)]] void handle_terminate() {
  std::set_terminate(&end_at_once);
  std::set_new_handler(&note_lack_of_memory);
}

/// Prepares the process so that all failures can be reported: opens missing standard streams,
/// handles termination signals, and makes failed writes return errors instead of raising signals.
void prepare_process() {
  fill_standard_streams();
  handle_crashes();
  // A closed pipe, or a file at its size limit, is an error to report, not a reason to be killed.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  // If the parent ignores it, exit statuses of children are lost.
  static_cast<void>(std::signal(SIGCHLD, SIG_DFL));
  system::end_on_termination_signals(
      [](const auto& message) { return static_cast<int>(report_termination(message)); });
}

}  // namespace
}  // namespace twrench::app

int main(int argc, char** argv) try {
  twrench::app::prepare_process();
  return static_cast<int>(twrench::app::run(argc, argv));
} catch (...) {  // there is not enough memory to report it
  twrench::app::end_at_once();
}
