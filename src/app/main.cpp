#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "app/commands.h"
#include "app/version.h"
#include "base/error.h"

using twrench::ExitCode;

namespace {

ExitCode fail(ExitCode code, const std::string& message, const std::string& remedy = {}) {
  fmt::print(stderr, "twrench: error: {}\n", message);
  if (!remedy.empty()) fmt::print(stderr, "  {}\n", remedy);
  return code;
}

ExitCode run(int argc, char** argv) {
  CLI::App app("From a rigid body's equations of motion to a film of it", "twrench");
  app.set_version_flag("--version", twrench::version_line());
  app.require_subcommand(1);
  ExitCode code = ExitCode::done;
  twrench::add_commands(app, code);
  try {
    twrench::require_known_command(app, argc > 1 ? argv[1] : "-");
    app.parse(argc, argv);
    return code;
  } catch (const CLI::Success& request) {  // --help, --version
    app.exit(request);
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    return fail(ExitCode::usage, fmt::format("command line: {}", error.what()),
                "see twrench --help, and twrench COMMAND --help");
  } catch (const twrench::Error& error) {
    return fail(error.code(), error.what(), error.remedy());
  } catch (const std::exception& error) {
    return fail(ExitCode::internal, fmt::format("internal: {}", error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that went away is an error to report, not a death
  return static_cast<int>(run(argc, argv));
}
