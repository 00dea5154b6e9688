#include "system/processors.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <thread>

namespace twrench::system {
namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The limit that a single group sets, in the files of either version: "QUOTA PERIOD" in one file,
/// or a file for each of the two. Without a limit the quota is "max" or negative.
double limit_of_group(const fs::path& group) {
  std::ifstream both(group / "cpu.max");
  std::ifstream quota_file(group / "cpu.cfs_quota_us"), period_file(group / "cpu.cfs_period_us");
  double quota = 0, period = 0;
  const bool is_set = both >> quota >> period || (quota_file >> quota && period_file >> period);
  return is_set && quota > 0 && period > 0 ? quota / period : unlimited;
}

/// The least limit of a group and its ancestors up to the mount. In a container the group may have
/// the name that it has outside, so that only the mount is found.
double limit_of_branch(const fs::path& mount, const fs::path& name) {
  double limit = limit_of_group(mount);
  fs::path group = mount;
  for (const fs::path& part : name.lexically_normal().relative_path()) {
    group /= part;
    limit = std::min(limit, limit_of_group(group));
  }
  return limit;
}

/// Whether a list separated by commas has the name.
bool lists(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const std::size_t length = std::min(list.find(','), list.size());
    if (list.substr(0, length) == name) return true;
    list.remove_prefix(std::min(length + 1, list.size()));
  }
  return false;
}

/// The processors that the process may run on, which hardware_concurrency() does not consider in
/// every version of the C library.
unsigned allowed_processors() {
  cpu_set_t allowed;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
    return static_cast<unsigned>(CPU_COUNT(&allowed));
  }
  return std::max(1U, std::thread::hardware_concurrency());  // more than the set can represent
}

}  // namespace

unsigned processor_count() {
  const double limit = processor_limit("/proc/self/cgroup", "/sys/fs/cgroup");
  return static_cast<unsigned>(std::min<double>(allowed_processors(), std::ceil(limit)));
}

double processor_limit(const fs::path& groups, const fs::path& mounts) {
  std::ifstream file(groups);
  double limit = unlimited;
  for (std::string line; std::getline(file, line);) {  // "NUMBER:CONTROLLERS:GROUP"
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path name = line.substr(second + 1);
    if (controllers.empty()) limit = std::min(limit, limit_of_branch(mounts, name));
    if (lists(controllers, "cpu")) limit = std::min(limit, limit_of_branch(mounts / "cpu", name));
  }
  return limit;
}

}  // namespace twrench::system
