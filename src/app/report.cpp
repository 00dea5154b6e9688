#include "app/report.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "app/message.h"
#include "base/file.h"

namespace twrench {
namespace {

ExitCode report(ExitCode code, const std::string& message, const std::string& remedy = {}) {
  say("twrench: error: {}\n", message);
  if (!remedy.empty()) say("  {}\n", remedy);
  return code;
}

ExitCode report(const Error& error) { return report(error.code(), error.what(), error.remedy()); }

/// Which resources the running command could use less of.
std::string remedy_for_memory(const CLI::App& app) {
  const auto has_jobs = [](const CLI::App* command) {
    return command->get_option_no_throw("--jobs") != nullptr;
  };
  const bool draws = std::ranges::any_of(app.get_subcommands(), has_jobs);
  if (draws) return "use a smaller --size, fewer --samples or fewer --jobs";
  return "close other programs, or raise the limit on memory (ulimit -v)";
}

/// The FileError for a system error that no code of ours expected.
FileError refused(const std::system_error& error) {
  const int number = error.code().value();
  if (error.code() == std::errc::resource_unavailable_try_again) {
    return {"cannot start a thread", error.code().message(),
            "raise the limit on processes (ulimit -u, or that of the container)"};
  }
  const auto* at = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
  const bool has_path = at != nullptr && !at->path1().empty();
  return file_error(has_path ? "cannot use " + at->path1().string() : "cannot continue", number);
}

bool is_of_the_system(const std::system_error& error) {
  return error.code().category() == std::system_category() ||
         error.code().category() == std::generic_category();
}

}  // namespace

ExitCode report_current_exception(const CLI::App& app) {
  try {
    throw;
  } catch (const Error& error) {
    return report(error);
  } catch (const std::bad_alloc&) {
    return report(ExitCode::internal, "memory: out of memory", remedy_for_memory(app));
  } catch (const std::system_error& error) {
    if (is_of_the_system(error)) return report(refused(error));
    return report(ExitCode::internal, std::string("internal: ") + error.what());
  } catch (const std::exception& error) {
    return report(ExitCode::internal, std::string("internal: ") + error.what());
  }
}

void report_termination(const TerminationMessage& message) {
  report(ExitCode::interrupted, message.error, message.remedy);
}

}  // namespace twrench
