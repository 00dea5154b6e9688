#include "snapshot.h"

#include <exception>
#include <system_error>

#include "system/bytes.h"
#include "system/file.h"

namespace twrench::torture {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_read = std::size_t{1} << 26U;

Entry entry_at(const fs::path& path) {
  const fs::file_status status = fs::symlink_status(path);
  Entry entry{status.type(), status.permissions(), {}};
  if (fs::is_symlink(status)) {
    entry.content = fs::read_symlink(path).string();
  } else if (fs::is_regular_file(status)) {
    const auto size = fs::file_size(path);
    try {
      entry.content = size > longest_read
                          ? std::to_string(size)
                          : system::sha256_hex(system::read_file(path, longest_read));
    } catch (const std::exception&) {
      entry.content = std::to_string(size);
    }
  }
  return entry;
}

}  // namespace

Snapshot take_snapshot(const fs::path& folder) {
  Snapshot found;
  constexpr auto options = fs::directory_options::skip_permission_denied;
  for (const auto& entry : fs::recursive_directory_iterator(folder, options)) {
    found[entry.path().lexically_relative(folder).string()] = entry_at(entry.path());
  }
  return found;
}

std::map<std::string, std::string> frame_digests(const fs::path& folder) {
  std::map<std::string, std::string> found;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(folder, missing)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("frame_"))
      found[name] = system::sha256_hex(system::read_file(entry.path(), longest_read));
  }
  return found;
}

}  // namespace twrench::torture
