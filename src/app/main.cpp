#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/output.h"
#include "app/report.h"
#include "app/usage.h"
#include "base/termination.h"

namespace {

/// Runs the command that the words name, or prints the help or version that they ask for.
void parse(CLI::App& app, std::vector<std::string> words) try {
  app.parse(std::move(words));
} catch (const CLI::Success& request) {
  std::ostringstream text;
  app.exit(request, text, text);
  twrench::write_output("-", text.str());
} catch (const CLI::ParseError& error) {
  throw twrench::usage_error(app, error);
}

twrench::ExitCode run(int argc, char** argv) {
  CLI::App app("From a rigid body's equations of motion to a film of it", "twrench");
  twrench::ExitCode code = twrench::ExitCode::done;
  try {
    twrench::add_commands(app, code);
    twrench::require_known_command(app, argc > 1 ? argv[1] : "-");
    parse(app, twrench::words_for_parser(argc, argv));
    return code;
  } catch (...) {
    return twrench::report_current_exception(app);
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
