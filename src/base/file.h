#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"
#include "base/error.h"

namespace twrench {

/// A FileError for the system's error number, with the remedy where that number suggests one:
/// "cannot write out/a.png: No space left on device".
FileError file_error(const std::string& what, int error_number);

/// Makes the folder, and those it lies in, where they are missing. Throws FileError.
void make_folder(const std::filesystem::path& folder);

/// A new file beside `target`, under a name that nobody else has, which becomes the target by
/// commit() or vanishes. So a reader of the target finds it old, new or missing, never half
/// written, whenever this process dies; what a killed one leaves is a hidden file
/// ".NAME.PID-N.tmp".
class PendingFile {
 public:
  /// Throws FileError when the file cannot be made, or when the target is there and is no regular
  /// file (a folder, a device).
  explicit PendingFile(std::filesystem::path target);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& target() const { return target_; }

  /// The temporary name, in the target's folder.
  const std::filesystem::path& path() const { return path_; }

  /// Appends the bytes. Throws FileError.
  void write(std::span<const std::uint8_t> bytes);

  /// Closes the file and gives it the target's name. Throws FileError.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
  Descriptor folder_;
  Descriptor descriptor_;
};

/// Makes `path` hold exactly these bytes, by way of a PendingFile. Throws FileError.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// The bytes of the file. Throws FileError when it cannot be read, or is longer than `max_bytes`
/// (what is read is input: it must not exhaust the memory).
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace twrench
