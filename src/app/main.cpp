#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "app/commands.h"
#include "app/report.h"
#include "app/version.h"
#include "base/termination.h"

namespace {

twrench::ExitCode run(int argc, char** argv) {
  CLI::App app("From a rigid body's equations of motion to a film of it", "twrench");
  app.set_version_flag("--version", twrench::version_line());
  app.require_subcommand(1);
  twrench::ExitCode code = twrench::ExitCode::done;
  twrench::add_commands(app, code);
  try {
    twrench::require_known_command(app, argc > 1 ? argv[1] : "-");
    app.parse(argc, argv);
    return code;
  } catch (const CLI::Success& request) {  // --help, --version
    app.exit(request);
    return twrench::ExitCode::done;
  } catch (...) {
    return twrench::report_current_exception();
  }
}

/// Opens those of standard input, output and error that are closed, so that they fail as before: a
/// file that got one of their numbers would get what is meant for them.
void fill_standard_streams() {
  for (const int descriptor : {0, 1, 2}) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    ::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);  // gets the lowest free number
  }
}

}  // namespace

int main(int argc, char** argv) try {
  fill_standard_streams();
  // A reader that went away, and a file that may not grow, are errors to report, not a death.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  twrench::end_on_termination_signals(&twrench::report_termination);
  return static_cast<int>(run(argc, argv));
} catch (...) {  // there is not the memory to report it
  return static_cast<int>(twrench::ExitCode::internal);
}
