#include "system/pending_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "system/error.h"
#include "system/file.h"
#include "system/file_lock.h"

namespace twrench::system {
namespace {

namespace fs = std::filesystem;

std::string cannot_write(const fs::path& path) { return "cannot write " + path.string(); }

/// Returns the descriptor that the path names, as /dev/fd/3 does; -1 for other paths. The
/// descriptor itself is used, because reopening the path would start at the beginning of a file
/// that a shell opened for appending.
int named_descriptor(const fs::path& path) {
  const std::string text = path.string();
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!text.starts_with(folder)) continue;
    int descriptor = -1;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + folder.size(), end, descriptor);
    if (error == std::errc{} && stop == end) return descriptor;
  }
  return -1;
}

/// Fits a path component of 255 bytes with room for prefix and suffix.
std::string shortened(const std::string& name) { return name.substr(0, 200); }

/// The part before the process number in the name of a temporary file.
std::string temporary_prefix(const fs::path& target) {
  return fmt::format(".{}.", shortened(target.filename().string()));
}
constexpr std::string_view temporary_suffix = ".tmp";

/// Creates and opens a file in the target's folder. O_EXCL neither follows links nor opens an
/// existing file.
Descriptor open_beside(const fs::path& target, const Descriptor& folder, fs::path& path,
                       std::string& name) {
  constexpr int most_leftovers = 10'000;  // left by killed processes with our process number
  for (int n = 0; n < most_leftovers; ++n) {
    name = fmt::format("{}{}-{}{}", temporary_prefix(target), ::getpid(), n, temporary_suffix);
    path = target.parent_path() / name;
    Descriptor descriptor(
        ::openat(folder.get(), name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (descriptor || errno != EEXIST) return descriptor;
  }
  return {};
}

/// Returns the status of the target, or of the link itself if links are replaced.
std::optional<struct stat> status_of(const fs::path& path, Links links) {
  struct stat status {};
  const int failed =
      links == Links::follow ? ::stat(path.c_str(), &status) : ::lstat(path.c_str(), &status);
  if (failed == 0) return status;
  // For example, if the name is too long.
  if (errno != ENOENT) throw file_error(cannot_write(path), errno);
  return std::nullopt;
}

/// Devices and pipes are written to, not replaced.
bool is_device(const struct stat& status) {
  return !S_ISREG(status.st_mode) && !S_ISLNK(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Throws if the existing target must not be written.
void check_target(const fs::path& target, const fs::path& destination, const struct stat& status,
                  Links links) {
  if (S_ISDIR(status.st_mode)) {
    throw FileError(cannot_write(target), "it is a folder", "choose another name");
  }
  if (is_device(status) && links == Links::replace) {
    throw FileError(cannot_write(target), "it exists and is not a regular file",
                    "choose another name");
  }
  if (!S_ISLNK(status.st_mode) &&
      ::faccessat(AT_FDCWD, destination.c_str(), W_OK, AT_EACCESS) != 0) {
    throw file_error(cannot_write(target), errno);
  }
}

/// Changes the owner first, since that may reset mode bits. Being unable to change the owner is no
/// reason not to write the file.
void keep_mode_and_owner(const Descriptor& file, const struct stat& status) {
  static_cast<void>(::fchown(file.get(), status.st_uid, status.st_gid) == 0);
  static_cast<void>(::fchmod(file.get(), status.st_mode & 07777U) == 0);
}

}  // namespace

bool is_named_descriptor(const fs::path& path) { return named_descriptor(path) >= 0; }

fs::path link_target(const fs::path& target) {
  constexpr int most_links = 40;  // As Linux.
  fs::path path = target;
  for (int n = 0; n < most_links; ++n) {
    std::error_code failed;
    if (is_named_descriptor(path) || !fs::is_symlink(fs::symlink_status(path, failed))) {
      return path;
    }
    const fs::path next = fs::read_symlink(path, failed);
    if (failed) throw file_error(cannot_write(target), failed.value());
    path = path.parent_path() / next;  // an absolute path replaces it
  }
  throw file_error(cannot_write(target), ELOOP);
}

PendingFile::PendingFile(fs::path target, Links links)
    : target_(std::move(target)),
      destination_(links == Links::follow ? link_target(target_) : target_) {
  const bool is_named = is_named_descriptor(destination_);
  const auto status = is_named ? std::nullopt : status_of(destination_, links);
  if (status) check_target(target_, destination_, *status, links);
  if (is_named || (status && is_device(*status))) {
    open_directly();
  } else {
    open_temporary();
    if (status && S_ISREG(status->st_mode)) keep_mode_and_owner(descriptor_, *status);
  }
}

void PendingFile::open_directly() {
  path_ = destination_;
  const int named = named_descriptor(destination_);
  descriptor_ = Descriptor(named >= 0 ? ::fcntl(named, F_DUPFD_CLOEXEC, 0)
                                      : ::open(destination_.c_str(), O_WRONLY | O_CLOEXEC));
  if (!descriptor_) throw file_error(cannot_write(target_), errno);
}

void PendingFile::open_temporary() {
  const std::string parent =
      destination_.has_parent_path() ? destination_.parent_path().string() : ".";
  folder_ = Descriptor(::open(parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!folder_) throw file_error(cannot_write(target_), errno);
  // No signal may end us between creating the temporary file and registering its removal.
  const auto hold = hold_termination();
  removal_.emplace([this](TerminationMessage&) { remove_temporary(); });
  // From here on nothing allocates: a failed allocation would leave the file behind.
  descriptor_ = open_beside(destination_, folder_, path_, temporary_);
  if (!descriptor_) throw file_error(cannot_write(target_), errno);
}

void PendingFile::remove_temporary() const noexcept {
  ::unlinkat(folder_.get(), temporary_.c_str(), 0);  // wherever the folder has moved
}

PendingFile::~PendingFile() {
  if (!removal_) return;
  const auto hold = hold_termination();
  remove_temporary();
  removal_.reset();
}

void PendingFile::claim() {
  if (is_direct()) return;
  lock_file(descriptor_, LOCK_EX);
  claim_ = Descriptor(::fcntl(descriptor_.get(), F_DUPFD_CLOEXEC, 0));
  std::error_code failed;
  const fs::path folder = destination_.has_parent_path() ? destination_.parent_path() : ".";
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const std::string name = entry.path().filename().string();
    const bool is_of_target = name.starts_with(temporary_prefix(destination_)) &&
                              name.ends_with(temporary_suffix) && name != path_.filename();
    if (!is_of_target) continue;
    const Descriptor other(::open(entry.path().c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (other && !lock_file(other, LOCK_SH)) {
      throw FileError(cannot_write(target_), "another run is writing it",
                      "wait for it to finish, or choose another name");
    }
  }
}

void PendingFile::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw file_error(cannot_write(target_), errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void PendingFile::commit() {
  const auto hold = hold_termination();
  // On network file systems and with quotas, a full disk is reported only by close.
  const bool closed = descriptor_.close();
  if (!closed || (!is_direct() && std::rename(path_.c_str(), destination_.c_str()) != 0)) {
    throw file_error(cannot_write(target_), errno);
  }
  removal_.reset();
}

}  // namespace twrench::system
