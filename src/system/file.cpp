#include "system/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>
#include <utility>

#include "system/descriptor.h"
#include "system/pending_file.h"

namespace twrench::system {
namespace {

std::string remedy_for(int error_number, Access access) {
  switch (error_number) {
    case ENOENT:
      return access == Access::read ? "check the name"
                                    : "create its folder first, or check the path";
    case ENOTDIR:
      return "part of the path is a file, not a folder";
    case ENAMETOOLONG:
      return "choose a shorter name: at most 255 bytes per path component";
    case EISDIR:
      return access == Access::read ? "name a file in it" : "choose another name";
    case ELOOP:
      return "its symbolic links form a loop";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a location that you can read and write";
    case ENOSPC:
    case EDQUOT:
      return "free some space there, or choose another disk";
    case EBADF:
      return "it is closed: redirect it to a file or a program";
    case EFBIG:
      return "raise the limit on file size (ulimit -f), or choose another disk";
    case EMFILE:
    case ENFILE:
      return "raise the limit on open files (ulimit -n)";
    default:
      return {};
  }
}

std::string cannot_read(const std::filesystem::path& path) {
  return "cannot read " + path.string();
}

std::vector<std::uint8_t> read_all(const std::filesystem::path& path, const Descriptor& file,
                                   std::size_t max_bytes) {
  const std::string what = cannot_read(path);
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) {
    throw file_error(what, errno, Access::read);
  }
  // The size is only a hint, as a pipe has none. One extra byte detects the end of file without
  // growing.
  const auto hint = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  std::vector<std::uint8_t> bytes(std::min(std::max<std::size_t>(hint, 4096), max_bytes) + 1);
  std::size_t size = 0;
  while (true) {
    const ssize_t got = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      throw file_error(what, errno, Access::read);
    }
    if (got == 0) {
      break;
    }
    size += static_cast<std::size_t>(got);
    if (size > max_bytes) {
      throw FileError(what, fmt::format("it is longer than {} bytes", max_bytes));
    }
    if (size == bytes.size()) {
      bytes.resize(std::min(2 * size, max_bytes + 1));
    }
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

FileError file_error(const std::string& what, int error_number, Access access) {
  return {what, std::generic_category().message(error_number), remedy_for(error_number, access)};
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw file_error("cannot create the folder " + folder.string(), failed.value());
  }
}

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  PendingFile file(path);
  file.write(bytes);
  file.commit();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
  write_file_atomically(path,
                        std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  return read_all(path, Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), max_bytes);
}

std::vector<std::uint8_t> read_regular_file(const std::filesystem::path& path,
                                            std::size_t max_bytes) {
  // Without O_NONBLOCK, opening a pipe would wait for a writer.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file && ::fstat(file.get(), &status) == 0 && !S_ISREG(status.st_mode)) {
    throw FileError(cannot_read(path), "it is not a regular file");
  }
  return read_all(path, std::move(file), max_bytes);
}

namespace fs = std::filesystem;

fs::path existing_folder(const fs::path& folder) {
  std::error_code failed;
  fs::path path = fs::absolute(folder.empty() ? fs::path(".") : folder, failed);
  while (!fs::exists(path, failed) && path != path.parent_path()) path = path.parent_path();
  return path;
}

std::uintmax_t free_space(const fs::path& folder) {
  std::error_code unknown;
  const fs::space_info space = fs::space(existing_folder(folder), unknown);
  return unknown ? std::numeric_limits<std::uintmax_t>::max() : space.available;
}

bool on_same_disk(const fs::path& a, const fs::path& b) {
  struct stat of_a {};
  struct stat of_b {};
  return ::stat(existing_folder(a).c_str(), &of_a) == 0 &&
         ::stat(existing_folder(b).c_str(), &of_b) == 0 && of_a.st_dev == of_b.st_dev;
}

std::string format_bytes(double bytes) {
  constexpr double thousand = 1000;
  for (const char* unit : {"bytes", "kB", "MB", "GB"}) {
    if (bytes < thousand) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= thousand;
  }
  return fmt::format("{:.1f} TB", bytes);
}

}  // namespace twrench::system
