#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "system/error.h"

namespace twrench::system {

/// The kind of access that failed.
enum class Access { read, write };

/// Returns a FileError for a system error number, for example "cannot write out/a.png: No space
/// left on device", with a remedy where the number suggests one.
FileError file_error(const std::string& what, int error_number, Access access = Access::write);

/// Creates the folder and its missing ancestors. Throws FileError.
void make_folder(const std::filesystem::path& folder);

/// Replaces the contents of `path` with exactly these bytes through a PendingFile. Throws
/// FileError.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Returns the bytes of the file. Throws FileError if it cannot be read or is longer than
/// `max_bytes`, because input must not exhaust the memory.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Like read_file(), but also throws FileError if it is not a regular file: reading a pipe could
/// block for ever.
std::vector<std::uint8_t> read_regular_file(const std::filesystem::path& path,
                                            std::size_t max_bytes);

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
