#include "app/output.h"

#include <cerrno>
#include <cstdio>

#include "base/file.h"

namespace twrench {

void write_output(const std::string& path, const std::string& text) {
  if (path != "-") return write_file_atomically(path, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw file_error("cannot write standard output", errno);
  }
}

}  // namespace twrench
