#include "table/input.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "system/file.h"

namespace twrench::table {
namespace {

constexpr std::size_t window_bytes = 1 << 18;

std::string cannot_read_input(const std::string& name) { return "cannot read " + name; }

}  // namespace

Input::Input(const std::filesystem::path& path) : name_(path.string()) {
  if (name_ == "-") {
    throw InvalidArgument("-", "standard input cannot be used: the rows are read more than once",
                          "save it to a file, and name that");
  }
  // Without O_NONBLOCK, opening a pipe would wait for a writer.
  file_ = system::Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!file_ || ::fstat(file_.get(), &status) != 0) {
    throw system::file_error(cannot_read_input(name_), errno, system::Access::read);
  }
  if (S_ISDIR(status.st_mode)) {
    throw system::file_error(cannot_read_input(name_), EISDIR, system::Access::read);
  }
  if (!S_ISREG(status.st_mode)) {
    throw system::FileError(cannot_read_input(name_), "it is not a regular file",
                            "save its output to a file, because the rows are read more than once");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

Input::Input(std::string name, std::string_view bytes)
    : name_(std::move(name)), size_(bytes.size()), bytes_(bytes) {}

Input::Input(std::string name, std::shared_ptr<const std::string> bytes)
    : name_(std::move(name)), size_(bytes->size()), shared_(std::move(bytes)), bytes_(*shared_) {}

std::size_t Input::read(std::uint64_t offset, char* to, std::size_t length) const {
  if (!file_) {
    if (offset >= bytes_.size()) return 0;
    return bytes_.copy(to, length, static_cast<std::size_t>(offset));
  }
  std::size_t done = 0;
  while (done < length) {
    const ssize_t got =
        ::pread(file_.get(), to + done, length - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw system::file_error(cannot_read_input(name_), errno, system::Access::read);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  if (done < length) require_unchanged();
  return done;
}

/// A file that is still written may end within a number, and each pass would read other rows.
void Input::require_unchanged() const {
  struct stat status {};
  if (::fstat(file_.get(), &status) != 0) {
    throw system::file_error(cannot_read_input(name_), errno, system::Access::read);
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size == size_) return;
  throw system::FileError(
      name_, fmt::format("it became {} while it was read", size < size_ ? "shorter" : "longer"),
      "wait until the program that writes it has ended, or read a copy of it");
}

std::string_view Window::at(std::uint64_t offset, std::size_t length) {
  if (offset < begin_ || offset + length > begin_ + filled_) {
    buffer_.resize(std::max(window_bytes, length));
    begin_ = offset;
    filled_ = input_->read(offset, buffer_.data(), buffer_.size());
  }
  const auto first = static_cast<std::size_t>(offset - begin_);
  return {buffer_.data() + first, std::min(length, filled_ - std::min(first, filled_))};
}

}  // namespace twrench::table
