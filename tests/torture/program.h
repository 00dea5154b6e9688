#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace twrench::torture {

using Seconds = std::chrono::duration<double>;

/// A program to run, and for how long.
struct Program {
  std::vector<std::string> command;
  std::filesystem::path folder;  ///< its working directory
  std::filesystem::path said;    ///< output goes to the files with this name and .out or .err
  Seconds until_asked{120};      ///< after which it gets SIGTERM; long, for a busy machine
  Seconds until_killed{20};      ///< after that, SIGKILL
};

/// The result of a run. The first megabytes of its output are kept.
struct Ended {
  int code = -1;               ///< exit code; -1 if a signal ended it
  int signal = 0;              ///< the signal that ended it
  bool asked_to_stop = false;  ///< it got SIGTERM
  bool was_killed = false;     ///< it ignored SIGTERM
  std::string out, err;
};

/// Runs the program in a new process group, which is killed afterwards. To protect the machine,
/// memory is limited to a few gigabytes and files to 200 MB.
Ended run(const Program& program);

/// Returns the words quoted for a shell, in printable characters.
std::string shell_quoted(const std::vector<std::string>& words);

/// Creates a new empty folder.
std::filesystem::path make_scratch_folder(const std::string& name);

/// Removes a folder that may contain folders its owner may not enter.
void remove_folder(const std::filesystem::path& folder);

}  // namespace twrench::torture
