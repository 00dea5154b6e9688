#pragma once

#include <filesystem>

#include "base/descriptor.h"

namespace twrench {

/// Whether others may work in the folder at the same time: those that share it with each other.
enum class LockKind { exclusive, shared };

/// Keeps other runs of this program out of a folder, while it lives. The system ends it with the
/// process, however it dies; nothing is left in the folder. Where the file system knows no locks,
/// it keeps nobody out.
class FolderLock {
 public:
  /// Throws FileError where another process has the folder, and the two do not both share it.
  FolderLock(const std::filesystem::path& folder, LockKind kind);

 private:
  Descriptor folder_;
};

}  // namespace twrench
