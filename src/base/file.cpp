#include "base/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace twrench {
namespace {

std::string remedy_for(int error_number) {
  switch (error_number) {
    case ENOENT:
    case ENOTDIR:
      return "check the path: each folder in it must exist";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place where you may read and write";
    case ENOSPC:
    case EDQUOT:
      return "free some space there, or choose another disk";
    case EMFILE:
    case ENFILE:
      return "raise the limit on open files (ulimit -n)";
    default:
      return {};
  }
}

/// What fits a path component of 255 bytes with room for the decoration.
std::string shortened(const std::string& name) { return name.substr(0, 200); }

/// Makes and opens a file beside target, in its folder, which is opened too. O_EXCL neither follows
/// a link nor takes another's file.
Descriptor open_beside(const std::filesystem::path& target, Descriptor& folder,
                       std::filesystem::path& path) {
  const std::string parent = target.has_parent_path() ? target.parent_path().string() : ".";
  folder = Descriptor(::open(parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!folder) return {};
  constexpr int most_leftovers = 10'000;  // of killed processes that had our number
  for (int n = 0; n < most_leftovers; ++n) {
    const std::string name =
        fmt::format(".{}.{}-{}.tmp", shortened(target.filename().string()), ::getpid(), n);
    path = target.parent_path() / name;
    Descriptor descriptor(
        ::openat(folder.get(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (descriptor || errno != EEXIST) {
      return descriptor;
    }
  }
  return {};
}

std::string cannot_write(const std::filesystem::path& path) {
  return "cannot write " + path.string();
}

}  // namespace

FileError file_error(const std::string& what, int error_number) {
  return {what, std::generic_category().message(error_number), remedy_for(error_number)};
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) {
    throw file_error("cannot make the folder " + folder.string(), failed.value());
  }
}

PendingFile::PendingFile(std::filesystem::path target) : target_(std::move(target)) {
  std::error_code missing;
  const auto status = std::filesystem::status(target_, missing);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw FileError(cannot_write(target_), "it is there and is not a regular file",
                    "choose another name");
  }
  descriptor_ = open_beside(target_, folder_, path_);
  if (!descriptor_) {
    throw file_error(cannot_write(target_), errno);
  }
}

PendingFile::~PendingFile() {
  if (!path_.empty()) {
    ::unlinkat(folder_.get(), path_.filename().c_str(), 0);  // wherever the folder is by now
  }
}

void PendingFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      throw file_error(cannot_write(target_), errno);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void PendingFile::commit() {
  // On a network or a quota, close is where a full disk is told.
  const bool closed = descriptor_.close();
  if (!closed || std::rename(path_.c_str(), target_.c_str()) != 0) {
    throw file_error(cannot_write(target_), errno);
  }
  path_.clear();
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
  const std::string what = "cannot read " + path.string();
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) {
    throw file_error(what, errno);
  }
  // The size is a hint: a pipe has none. One byte more shows the end without growing.
  const auto hint = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  std::vector<std::uint8_t> bytes(std::min(std::max<std::size_t>(hint, 4096), max_bytes) + 1);
  std::size_t size = 0;
  while (true) {
    const ssize_t got = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      throw file_error(what, errno);
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

}  // namespace twrench
