#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "system/descriptor.h"
#include "system/error.h"
#include "system/termination.h"

namespace twrench::system {

/// How to treat the name of an output file that is a symbolic link.
enum class Links {
  follow,   ///< Write the file that the link points to, as a shell does.
  replace,  ///< Replace the link by the file; its target is not ours to write.
};

/// Returns the target of the links, which need not exist; the path itself if it is no link. Throws
/// FileError if the links form a loop.
std::filesystem::path link_target(const std::filesystem::path& path);

/// Returns whether the path names a descriptor of this process, as /dev/fd/3 does.
bool is_named_descriptor(const std::filesystem::path& path);

/// A new file next to `target`, under a unique name, which commit() renames to the target;
/// otherwise it is removed, even if a signal ends the process. A reader of the target therefore
/// finds it old, new or missing, never partial; SIGKILL leaves a hidden file ".NAME.PID-N.tmp". An
/// existing target keeps its mode and, where permitted, its owner.
///
/// A target that is neither a regular file nor a folder (a device, a pipe, /dev/stdout) is never
/// replaced but opened and written directly.
class PendingFile {
 public:
  /// Throws FileError if the file cannot be created or the target is not writable.
  explicit PendingFile(std::filesystem::path target, Links links = Links::follow);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& target() const { return target_; }

  /// Returns where the bytes currently are: the temporary file in the target's folder, or the
  /// device itself.
  const std::filesystem::path& path() const { return path_; }

  /// Returns whether there is no temporary file: data is then written at once and cannot be read
  /// back.
  bool is_direct() const { return !folder_; }

  /// The descriptor for a child process to write to.
  int descriptor() const { return descriptor_.get(); }

  /// Claims the target. Throws FileError if the PendingFile of another process has claimed the same
  /// target and is not destroyed within some seconds. If it was destroyed, the target may be new.
  /// The system releases the claim when the process ends, however it ends.
  void claim();

  /// Appends the bytes. Throws FileError.
  void write(std::span<const std::uint8_t> bytes);

  /// Closes the file and renames it to the target. Throws FileError.
  void commit();

 private:
  void open_directly();
  void open_temporary();
  void remove_temporary() const noexcept;

  std::filesystem::path target_;       ///< As given, for messages.
  std::filesystem::path destination_;  ///< After following links.
  std::filesystem::path path_;
  std::string temporary_;  ///< The name in path_, stored so that removing it needs no memory.
  Descriptor folder_;      ///< The folder of the temporary file; none for a device.
  Descriptor descriptor_;
  Descriptor claim_;  ///< Keeps the lock of claim() until after the renaming.
  std::optional<TerminationAction> removal_;  ///< Set while there is a temporary file.
};

}  // namespace twrench::system
