#include "app/commands/commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "app/options/command_line.h"
#include "app/options/help.h"
#include "app/terminal/error_report.h"
#include "app/terminal/version.h"
#include "base/words.h"
#include "system/output.h"

namespace twrench::app {
namespace {

constexpr const char* exit_codes =
    "Exit codes:\n"
    "  0         success\n"
    "  1         compare: the images differ; study, check: a bound was exceeded; inertia: a link "
    "is "
    "impossible\n"
    "  2         invalid option or scene\n"
    "  3         no usable OpenGL context\n"
    "  4         ffmpeg (or gnuplot, for plots) is missing or failed\n"
    "  5         a file could not be read or written\n"
    "  70        internal error: a bug in twrench, or out of memory\n"
    "  130, 143  interrupted; all files written are complete";

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
  system::write_output(text.str());
} catch (const CLI::ParseError& error) {
  throw usage_error(app, error);
}

/// Throws InvalidArgument, suggesting the nearest command, if `word` is neither an option nor a
/// command.
void require_known_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with("-") || std::ranges::find(names, word) != names.end()) return;
  throw unknown_name("command", word, names);
}

}  // namespace

void add_commands(CLI::App& app, ExitCode& code) {
  set_help_format(app);  // before the commands, which inherit it
  app.set_version_flag("--version", version_text(), "Print the version and the licences, and exit")
      ->group(heading(OptionGroup::run));
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.footer(exit_codes);
  app.require_subcommand(1);
  add_render(app);
  add_simulate(app);
  add_export(app);
  add_page(app);
  add_report(app);
  add_plot(app);
  add_inertia(app, code);
  add_study(app, code);
  add_encode(app);
  add_compare(app, code);
  add_check(app, code);
  add_doctor(app, code);
  add_methods(app);
  add_scenes(app);
  add_schema(app);
  add_cases(app);
  add_help(app);
  add_help_all(app);
  refuse_meaningless_values(app);
}

ProgramModel program_model() {
  CLI::App app(about, "twrench");
  ExitCode code = ExitCode::done;
  add_commands(app, code);
  return {read_command(app), read_commands(app)};
}

ExitCode run(int argc, char** argv) {
  CLI::App app(about, "twrench");
  ExitCode code = ExitCode::done;
  try {
    add_commands(app, code);
    require_known_command(app, argc > 1 ? argv[1] : "-");
    parse(app, words_for_parser(argc, argv));
    return code;
  } catch (...) {
    return report_current_exception(draws(app));
  }
}

}  // namespace twrench::app
