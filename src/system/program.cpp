#include "system/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

namespace twrench::system {

std::string why_not_started(const std::system_error& error) {
  switch (error.code().value()) {
    case ENOENT:
      return "it was not found in PATH";
    case EACCES:
      return "the file in PATH is not executable";
    case ENOEXEC:
      return "the file in PATH is not a program for this machine";
    case EMFILE:
    case ENFILE:
      return "too many files are open";
    case EAGAIN:
      return "the limit on processes has been reached";
    case ENOMEM:
      return "not enough memory";
    default:
      return error.code().message();
  }
}

std::string remedy_for_start(const std::system_error& error, const std::string& installation) {
  switch (error.code().value()) {
    case ENOENT:
      return installation;
    case EACCES:
      return "make it executable (chmod +x), or remove it from PATH";
    case ENOEXEC:
      return "install the version for this machine";
    case EMFILE:
    case ENFILE:
      return "raise the limit on open files (ulimit -n)";
    case EAGAIN:
      return "raise the limit on processes (ulimit -u)";
    case ENOMEM:
      return "close other programs";
    default:
      return {};
  }
}

std::string error_summary(std::string_view output) {
  constexpr std::size_t longest = 600;
  std::string tail(output.substr(output.size() - std::min(output.size(), longest)));
  while (!tail.empty() && tail.back() == '\n') {
    tail.pop_back();
  }
  for (std::size_t at = 0; (at = tail.find('\n', at)) != std::string::npos;) {
    tail.replace(at, 1, "; ");
  }
  return tail.empty() ? "it printed no message" : tail;
}

std::string failure_of(const std::string& program, const ChildProcess& child, int status) {
  const std::string printed = error_summary(child.error_output());
  if (child.timed_out()) {
    return fmt::format("{} made no progress for {:.3g} s and was killed: {}", program,
                       std::chrono::duration<double>(child.time_waited()).count(), printed);
  }
  if (status == 0) {
    return fmt::format("{} ended before it had read all of its input: {}", program, printed);
  }
  return fmt::format("{} ended with exit status {}: {}", program, status, printed);
}

std::string shell_command(std::span<const std::string> command) {
  constexpr const char* plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=:,./@%";
  std::string line;
  for (const std::string& argument : command) {
    line += line.empty() ? "" : " ";
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) {
      line += argument;
      continue;
    }
    line += '\'';
    for (const char c : argument) {
      line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    line += '\'';
  }
  return line;
}

}  // namespace twrench::system
