#pragma once

#include <filesystem>

namespace twrench::system {

/// Returns how many processors this process can keep busy: those that it may run on (taskset, the
/// share of a batch job) or, if its control groups allow it the time of fewer (containers), that
/// number, rounded up. At least 1.
unsigned processor_count();

/// Returns how many processors' time the control groups of a process allow it; infinity if they set
/// no limit. `groups` is a file like /proc/self/cgroup, and the groups are mounted below `mounts`,
/// in version 1 or 2.
double processor_limit(const std::filesystem::path& groups, const std::filesystem::path& mounts);

}  // namespace twrench::system
