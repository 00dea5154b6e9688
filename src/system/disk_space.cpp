#include "system/disk_space.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <limits>
#include <system_error>

namespace twrench::system {
namespace fs = std::filesystem;

fs::path existing_folder(const fs::path& folder) {
  std::error_code failed;
  fs::path path = fs::absolute(folder.empty() ? fs::path(".") : folder, failed);
  while (!fs::exists(path, failed) && path != path.parent_path()) path = path.parent_path();
  return path;
}

std::uintmax_t free_space(const fs::path& folder) {
  std::error_code unknown;
  const fs::space_info space = fs::space(existing_folder(folder), unknown);
  return unknown ? std::numeric_limits<std::uintmax_t>::max() : space.available;
}

bool on_same_disk(const fs::path& a, const fs::path& b) {
  struct stat of_a {};
  struct stat of_b {};
  return ::stat(existing_folder(a).c_str(), &of_a) == 0 &&
         ::stat(existing_folder(b).c_str(), &of_b) == 0 && of_a.st_dev == of_b.st_dev;
}

std::string format_bytes(double bytes) {
  constexpr double thousand = 1000;
  for (const char* unit : {"bytes", "kB", "MB", "GB"}) {
    if (bytes < thousand) return fmt::format("{:.3g} {}", bytes, unit);
    bytes /= thousand;
  }
  return fmt::format("{:.1f} TB", bytes);
}

}  // namespace twrench::system
