#include <fcntl.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "app/commands.h"
#include "app/report.h"
#include "app/version.h"

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

/// Pictures come and go, a few at a time: their memory is kept, or the system would have to give
/// and clear its pages anew for each frame.
void keep_memory_of_pictures() {
  constexpr int largest = 32 << 20;  // bytes, that glibc allows: more than 3840 x 2160 RGB
  ::mallopt(M_MMAP_THRESHOLD, largest);
  ::mallopt(M_TRIM_THRESHOLD, 8 * largest);
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory_of_pictures();
  fill_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that went away is an error to report, not a death
  return static_cast<int>(run(argc, argv));
}
