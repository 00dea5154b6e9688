#include "system/descriptor.h"

#include <sys/mman.h>

#include <array>
#include <cerrno>

#include "system/file.h"

namespace twrench::system {

MemoryFile::MemoryFile(std::string_view text) : descriptor_(::memfd_create("twrench", 0)) {
  const std::string what = "cannot write a file in memory";
  if (!descriptor_) throw file_error(what, errno);
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw file_error(what, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::lseek(descriptor_.get(), 0, SEEK_SET) != 0) throw file_error(what, errno);
}

std::string MemoryFile::contents() const {
  std::string text;
  std::array<char, 4096> buffer{};
  while (true) {
    const ssize_t got =
        ::pread(descriptor_.get(), buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw file_error("cannot read a file in memory", errno);
    if (got == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace twrench::system
