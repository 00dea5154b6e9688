#pragma once

#include "base/descriptor.h"

namespace twrench {

/// Locks the open file or folder by flock(2) with `operation`, LOCK_EX or LOCK_SH. False where
/// another process has a lock that excludes it, and still has it after a second: one that is being
/// killed may take as long to end. Where the file system knows no locks, nobody is excluded.
bool lock_file(const Descriptor& file, int operation);

}  // namespace twrench
