#pragma once

#include <filesystem>

#include "system/descriptor.h"
#include "system/error.h"

namespace twrench::system {

/// Whether other runs may use the folder at the same time; those with a shared lock may share it.
enum class LockKind { exclusive, shared };

/// Keeps other runs of this program out of a folder during its lifetime. The system releases the
/// lock when the process ends, however it ends; nothing remains in the folder. It has no effect
/// where the file system does not support locks.
class FolderLock {
 public:
  /// Throws FileError if another process holds a conflicting lock.
  FolderLock(const std::filesystem::path& folder, LockKind kind);

 private:
  Descriptor folder_;
};

}  // namespace twrench::system
