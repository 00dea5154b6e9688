#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace twrench {

/// The folder or, while it is not made yet, the nearest above it that is there.
std::filesystem::path existing_folder(const std::filesystem::path& folder);

/// What is free for us, in bytes, where the folder is or, while it is not made yet, would be. Where
/// the system does not say, as much as can be.
std::uintmax_t free_space(const std::filesystem::path& folder);

/// Whether two folders share their space. Not known of one that lies nowhere: false.
bool on_same_disk(const std::filesystem::path& a, const std::filesystem::path& b);

/// "1.5 GB"
std::string format_bytes(double bytes);

}  // namespace twrench
