#pragma once

#include "system/descriptor.h"

namespace twrench::system {

/// Locks the open file or folder by flock(2) with `operation`, LOCK_EX or LOCK_SH. Returns false if
/// another process still holds a conflicting lock after three seconds, the time that a killed
/// process may take to end. Returns true where the file system does not support locks.
bool lock_file(const Descriptor& file, int operation);

}  // namespace twrench::system
