#include "program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Starts a program in a new process group, with output to files.
pid_t start(const std::vector<std::string>& words, const fs::path& out, const fs::path& err) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), flags, 0666);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, 0666);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t pid = -1;
  const int failed =
      ::posix_spawnp(&pid, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::system_error(failed, std::generic_category(), words[0]);
  return pid;
}

/// Returns whether the process ends within this time; sets its status.
bool ends_within(pid_t pid, Seconds time, int& status) {
  const auto end = Clock::now() + time;
  for (auto pause = std::chrono::microseconds(500); ::waitpid(pid, &status, WNOHANG) == 0;) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 2, std::chrono::microseconds(5000));
  }
  return true;
}

std::string first_megabytes(const fs::path& path) {
  std::string text(std::size_t{4} << 20U, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace

Ended run(const Program& program) {
  const fs::path out = program.said.string() + ".out", err = program.said.string() + ".err";
  // The limits are in kilobytes, and for files in blocks of 512 bytes. The limit is on data instead
  // of address space, because 256 threads may reserve more address space than that without using
  // it.
  std::vector<std::string> words{
      "sh", "-c",
      R"(cd "$1" && ulimit -c 0 && ulimit -d 6000000 && ulimit -f 400000 && shift && exec "$@")",
      "sh", program.folder.string()};
  words.insert(words.end(), program.command.begin(), program.command.end());
  const pid_t pid = start(words, out, err);
  Ended ended;
  int status = 0;
  if (!ends_within(pid, program.until_asked, status)) {
    ended.asked_to_stop = true;
    ::kill(pid, SIGTERM);
    if (!ends_within(pid, program.until_killed, status)) {
      ended.was_killed = true;
      ::kill(-pid, SIGKILL);
      ::waitpid(pid, &status, 0);
    }
  }
  ::kill(-pid, SIGKILL);
  if (WIFSIGNALED(status)) {
    ended.signal = WTERMSIG(status);
  } else {
    ended.code = WEXITSTATUS(status);
  }
  ended.out = first_megabytes(out);
  ended.err = first_megabytes(err);
  return ended;
}

std::string shell_quoted(const std::vector<std::string>& words) {
  constexpr const char* plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=:,./@%";
  std::string line;
  for (const std::string& word : words) {
    line += line.empty() ? "" : " ";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      line += word;
      continue;
    }
    line += "$'";
    for (const char c : word) {
      const auto byte = static_cast<unsigned char>(c);
      if (c == '\'' || c == '\\') {
        line += std::string("\\") + c;
      } else if (byte < 0x20 || byte >= 0x7f) {
        line += fmt::format("\\{:03o}", byte);
      } else {
        line += c;
      }
    }
    line += '\'';
  }
  return line;
}

fs::path make_scratch_folder(const std::string& name) {
  const char* const temporary = std::getenv("TMPDIR");  // NOLINT(concurrency-mt-unsafe)
  std::string path =
      fmt::format("{}/torture-{}-XXXXXX", temporary != nullptr ? temporary : "/tmp", name);
  if (::mkdtemp(path.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), path);
  }
  return path;
}

void remove_folder(const fs::path& folder) {
  std::error_code failed;
  for (fs::recursive_directory_iterator entry(folder, failed), end; entry != end;
       entry.increment(failed)) {
    if (fs::is_directory(entry->symlink_status(failed))) {
      fs::permissions(entry->path(), fs::perms::owner_all, failed);
    }
  }
  fs::remove_all(folder, failed);
}

}  // namespace twrench::torture
