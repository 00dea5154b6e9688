#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/options/usage.h"
#include "app/terminal/error_report.h"
#include "app/terminal/process.h"
#include "system/output.h"

namespace {

/// Returns whether the command that was given draws frames.
bool draws(const CLI::App& app) {
  return std::ranges::any_of(app.get_subcommands(), [](const CLI::App* command) {
    return command->get_option_no_throw("--jobs") != nullptr;
  });
}

/// Runs the given command, or prints the requested help or version.
void parse(CLI::App& app, std::vector<std::string> words) try {
  app.parse(std::move(words));
} catch (const CLI::Success& request) {
  std::ostringstream text;
  app.exit(request, text, text);
  twrench::system::write_output("-", text.str());
} catch (const CLI::ParseError& error) {
  throw twrench::app::usage_error(app, error);
}

twrench::app::ExitCode run(int argc, char** argv) {
  CLI::App app(twrench::app::about, "twrench");
  twrench::app::ExitCode code = twrench::app::ExitCode::done;
  try {
    twrench::app::add_commands(app, code);
    twrench::app::require_known_command(app, argc > 1 ? argv[1] : "-");
    parse(app, twrench::app::words_for_parser(argc, argv));
    return code;
  } catch (...) {
    return twrench::app::report_current_exception(draws(app));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  twrench::app::prepare_process();
  return static_cast<int>(run(argc, argv));
} catch (...) {  // there is not enough memory to report it
  twrench::app::end_at_once();
}
