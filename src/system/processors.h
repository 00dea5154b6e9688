#pragma once

#include <filesystem>

namespace twrench::system {

/// Returns how many processors this process can keep busy: those that it may run on (taskset, the
/// share of a batch job) or, if its control groups (containers) limit it to the time of fewer, that
/// number, rounded up. At least 1.
unsigned processor_count();

/// Returns the limit of a process's control groups in processors; infinity if they set no limit.
/// `groups` is a file like /proc/self/cgroup, and the groups are mounted below `mounts`, in version
/// 1 or 2.
double processor_limit(const std::filesystem::path& groups, const std::filesystem::path& mounts);

}  // namespace twrench::system
