#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace twrench::torture {

using Seconds = std::chrono::duration<double>;

/// A program to be run, and for how long.
struct Program {
  std::vector<std::string> command;
  std::filesystem::path folder;  ///< it runs in this one
  std::filesystem::path said;    ///< where what it says is kept, under this name and .out, .err
  Seconds until_asked{30};       ///< after which it gets SIGTERM
  Seconds until_killed{5};       ///< after that, SIGKILL
};

/// What a program did. Of what it said the first megabytes are kept.
struct Ended {
  int code = -1;               ///< of its exit; -1 where a signal ended it
  int signal = 0;              ///< that ended it
  bool asked_to_stop = false;  ///< it got SIGTERM
  bool was_killed = false;     ///< it did not hear SIGTERM
  std::string out, err;
};

/// Runs it in a process group of its own, of which nothing is left afterwards, with no more than a
/// few gigabytes of memory and files of 200 MB, so that no case eats the machine.
Ended run(const Program& program);

/// The words as a shell takes them, in printable characters.
std::string shell_quoted(const std::vector<std::string>& words);

/// A new empty folder of this program's own.
std::filesystem::path make_scratch_folder(const std::string& name);

/// Of a folder that may hold what its owner may not enter.
void remove_folder(const std::filesystem::path& folder);

}  // namespace twrench::torture
