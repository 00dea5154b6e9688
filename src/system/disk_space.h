#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace twrench::system {

/// Returns the folder or, if it does not exist yet, its nearest existing ancestor.
std::filesystem::path existing_folder(const std::filesystem::path& folder);

/// Returns the bytes available to this user at the folder or, if it does not exist yet, at its
/// location; the maximum if the system does not report them.
std::uintmax_t free_space(const std::filesystem::path& folder);

/// Returns whether two folders are on the same file system; false if the location of either is
/// unknown.
bool on_same_disk(const std::filesystem::path& a, const std::filesystem::path& b);

/// Formats a number of bytes, for example "1.5 GB".
std::string format_bytes(double bytes);

}  // namespace twrench::system
