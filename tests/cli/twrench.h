#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "scratch_folder.h"

namespace twrench {

/// What the program did with a command line.
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

/// The real program; where TWRENCH_TEST_BACKEND=egl says so, with EGL for its OpenGL.
inline std::string program() {
  const char* const backend = std::getenv("TWRENCH_TEST_BACKEND");
  if (backend == nullptr || std::string(backend) != "egl") return TWRENCH_BINARY;
  return TWRENCH_TESTS_DIR "/cli/twrench-egl.sh";
}

/// Runs `command` as a shell does, in `folder`, where `$TWRENCH` is the real program.
inline Outcome run_shell(const ScratchFolder& folder, const std::string& command) {
  const auto out = folder / "stdout.txt", err = folder / "stderr.txt";
  const std::string whole = "cd '" + folder.path().string() +
                            "' && export TWRENCH_BINARY='" TWRENCH_BINARY "' TWRENCH='" +
                            program() + "'; { " + command + "; } </dev/null >'" + out.string() +
                            "' 2>'" + err.string() + "'";
  const int status = std::system(whole.c_str());  // NOLINT(cert-env33-c): our own words
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

/// Runs the real program in `folder` with `arguments`, as a shell splits them; `before` may set
/// its environment ("PATH=/nowhere ").
inline Outcome run_twrench(const ScratchFolder& folder, const std::string& arguments,
                           const std::string& before = "") {
  return run_shell(folder, before + "\"$TWRENCH\" " + arguments);
}

}  // namespace twrench
