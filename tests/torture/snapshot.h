#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twrench::torture {

/// One entry of a folder, with what a run may change.
struct Entry {
  std::filesystem::file_type type{};  ///< of a link itself, not of its target
  std::filesystem::perms mode{};
  std::string content;  ///< digest of a file, target of a link; size if not readable

  bool operator==(const Entry&) const = default;
};

/// Everything below a folder, by relative path.
using Snapshot = std::map<std::string, Entry>;

Snapshot take_snapshot(const std::filesystem::path& folder);

/// Returns the digest of each frame file in the folder, by name.
std::map<std::string, std::string> frame_digests(const std::filesystem::path& folder);

}  // namespace twrench::torture
