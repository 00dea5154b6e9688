#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace twrench::torture {

/// One entry of a folder, as far as a run may change it.
struct Entry {
  std::filesystem::file_type type{};  ///< a link is a link, whatever it leads to
  std::filesystem::perms mode{};
  std::string content;  ///< digest of a file, target of a link; where not readable, its size

  bool operator==(const Entry&) const = default;
};

/// All that is below a folder, by its path relative to it.
using Snapshot = std::map<std::string, Entry>;

Snapshot take_snapshot(const std::filesystem::path& folder);

/// The digest of each frame's file in the folder, by name.
std::map<std::string, std::string> frame_digests(const std::filesystem::path& folder);

}  // namespace twrench::torture
