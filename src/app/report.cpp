#include "app/report.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "app/message.h"

namespace twrench {
namespace {

ExitCode report(ExitCode code, const std::string& message, const std::string& remedy = {}) {
  say("twrench: error: {}\n", message);
  if (!remedy.empty()) say("  {}\n", remedy);
  return code;
}

}  // namespace

ExitCode report_current_exception() {
  try {
    throw;
  } catch (const Error& error) {
    return report(error.code(), error.what(), error.remedy());
  } catch (const CLI::ParseError& error) {
    return report(ExitCode::usage, fmt::format("command line: {}", error.what()),
                  "see twrench --help, and twrench COMMAND --help");
  } catch (const std::bad_alloc&) {
    return report(ExitCode::internal, "memory: there is not enough of it",
                  "choose a smaller --size, fewer --samples, or fewer --jobs");
  } catch (const std::exception& error) {
    return report(ExitCode::internal, fmt::format("internal: {}", error.what()));
  }
}

void report_termination(const TerminationMessage& message) {
  report(ExitCode::interrupted, message.error, message.remedy);
}

}  // namespace twrench
