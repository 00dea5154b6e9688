#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace twrench {

/// What was to be done with a file.
enum class Access { read, write };

/// A FileError for the system's error number, with the remedy where that number suggests one:
/// "cannot write out/a.png: No space left on device".
FileError file_error(const std::string& what, int error_number, Access access = Access::write);

/// Makes the folder, and those it lies in, where they are missing. Throws FileError.
void make_folder(const std::filesystem::path& folder);

/// Throws OverwriteError where `output` is the file `input`, by whatever name. That either is not
/// there is no error.
void require_not_input(const std::filesystem::path& output, const std::filesystem::path& input);

/// Makes `path` hold exactly these bytes, by way of a PendingFile. Throws FileError.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// The bytes of the file. Throws FileError when it cannot be read, or is longer than `max_bytes`
/// (what is read is input: it must not exhaust the memory).
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// The same, and FileError too for what is not a regular file: a pipe in its place could make us
/// wait for ever.
std::vector<std::uint8_t> read_regular_file(const std::filesystem::path& path,
                                            std::size_t max_bytes);

}  // namespace twrench
