#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "scratch_folder.h"
#include "system/file.h"
#include "system/sha256.h"

namespace twrench {

/// The result of running a command line.
struct Outcome {
  int code = -1;
  std::string out, err;
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

/// Runs `command` in a shell in `folder`, where `$TWRENCH` is the real program.
inline Outcome run_shell(const ScratchFolder& folder, const std::string& command) {
  const auto out = folder / "stdout.txt", err = folder / "stderr.txt";
  const std::string whole = "cd '" + folder.path().string() +
                            "' && export TWRENCH_BINARY='" TWRENCH_BINARY "' TWRENCH='" +
                            program() + "'; { " + command + "; } </dev/null >'" + out.string() +
                            "' 2>'" + err.string() + "'";
  const int status = std::system(whole.c_str());  // NOLINT(cert-env33-c): our own words
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
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
