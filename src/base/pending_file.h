#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/descriptor.h"
#include "base/termination.h"

namespace twrench {

/// What becomes of a symbolic link that has the name of a file to be written.
enum class Links {
  follow,   ///< the file that it leads to is written, as a shell does
  replace,  ///< it is replaced by the file: what it leads to is not ours to write
};

/// A new file beside `target`, under a name that nobody else has, which becomes the target by
/// commit() or vanishes, also when a signal ends the process. So a reader of the target finds it
/// old, new or missing, never half written; what SIGKILL leaves is a hidden file ".NAME.PID-N.tmp".
/// A target that stands keeps its mode and, where we may give files away, its owner.
///
/// A target that is neither a regular file nor a folder (a device, a pipe, /dev/stdout) is never
/// replaced: it is opened, and written to directly.
class PendingFile {
 public:
  /// Throws FileError when the file cannot be made or the target may not be written to.
  explicit PendingFile(std::filesystem::path target, Links links = Links::follow);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& target() const { return target_; }

  /// Where the bytes are now: the temporary name in the target's folder, or the device itself.
  const std::filesystem::path& path() const { return path_; }

  /// Whether there is no temporary file: what is written is out at once, and cannot be read back.
  bool is_direct() const { return !folder_; }

  /// For a child process to write to.
  int descriptor() const { return descriptor_.get(); }

  /// Throws FileError where another process has a PendingFile of the same target that called this.
  /// The system ends the claim with the process, however it dies.
  void claim();

  /// Appends the bytes. Throws FileError.
  void write(std::span<const std::uint8_t> bytes);

  /// Closes the file and gives it the target's name. Throws FileError.
  void commit();

 private:
  void open_directly();
  void open_temporary();
  void remove_temporary() const noexcept;

  std::filesystem::path target_;       ///< as it was given, for messages
  std::filesystem::path destination_;  ///< what the links lead to
  std::filesystem::path path_;
  std::string temporary_;  ///< the name in path_: to remove it must not take memory
  Descriptor folder_;      ///< of the temporary; none for a device
  Descriptor descriptor_;
  std::optional<TerminationAction> removal_;  ///< while there is a temporary
};

}  // namespace twrench
