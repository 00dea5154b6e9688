#pragma once

#include <filesystem>

#include "system/descriptor.h"
#include "system/error.h"

namespace twrench::system {

/// Locks the open file or folder by flock(2) with `operation`, LOCK_EX or LOCK_SH. Returns false if
/// another process still holds a conflicting lock after three seconds, the time that a killed
/// process may take to end. Returns true where the file system does not support locks.
bool lock_file(const Descriptor& file, int operation);

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
