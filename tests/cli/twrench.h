#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "scratch_folder.h"
#include "system/bytes.h"
#include "system/file.h"

namespace twrench {

/// The result of running a command line.
struct Outcome {
  int code = -1;
  std::string out, err;
  /// Peak resident memory of the largest process, kB. Unlike the address space, it does not depend
  /// on what the threads reserve for stacks and allocation.
  long peak_memory = 0;
};

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The real program; with EGL as its backend if TWRENCH_TEST_BACKEND=egl.
inline std::string program() {
  const char* const backend = std::getenv("TWRENCH_TEST_BACKEND");
  if (backend == nullptr || std::string(backend) != "egl") return TWRENCH_BINARY;
  return TWRENCH_TESTS_DIR "/cli/twrench-egl.sh";
}

/// Runs the script in a shell and returns its wait status. Stores the resource usage of the shell
/// and its children in `used`. It calls fork() instead of std::system(), whose child shares the
/// memory of this process until it starts the shell, so that the kernel counts this memory too.
inline int run_script(const std::string& script, rusage& used) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", script.c_str(), nullptr);
    ::_exit(127);
  }
  int status = -1;
  while (child > 0 && ::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  return status;
}

/// Runs `command` in a shell in `folder`, where `$TWRENCH` is the real program.
inline Outcome run_shell(const ScratchFolder& folder, const std::string& command) {
  const auto out = folder / "stdout.txt", err = folder / "stderr.txt";
  const std::string whole = "cd '" + folder.path().string() +
                            "' && export TWRENCH_BINARY='" TWRENCH_BINARY "' TWRENCH='" +
                            program() + "'; { " + command + "; } </dev/null >'" + out.string() +
                            "' 2>'" + err.string() + "'";
  rusage used{};
  const int status = run_script(whole, used);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err), used.ru_maxrss};
}

/// Runs the real program in `folder` with `arguments`, split as by a shell; `before` may set its
/// environment ("PATH=/nowhere ").
inline Outcome run_twrench(const ScratchFolder& folder, const std::string& arguments,
                           const std::string& before = "") {
  return run_shell(folder, before + "\"$TWRENCH\" " + arguments);
}

/// The digest of each frame file in the folder, by name.
inline std::map<std::string, std::string> digests(const std::filesystem::path& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame_"))
      found[name] = system::sha256_hex(system::read_file(entry.path(), 1 << 24));
  }
  return found;
}

}  // namespace twrench
