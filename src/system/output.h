#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "system/error.h"
#include "system/file_list.h"
#include "system/pending_file.h"

namespace twrench::system {

/// Writes a command's data to a file, atomically, or to standard output for "-". Data is written in
/// pieces, so that it is never held in memory as a whole.
class Output {
 public:
  /// Writes to standard output.
  Output() = default;

  /// Throws FileError.
  explicit Output(const OutputFile& file);

  /// Throws FileError.
  void write(std::string_view text);

  /// Call this once after the last piece; otherwise a file keeps its old content. Throws FileError.
  void finish();

 private:
  void pass_on();

  std::optional<PendingFile> file_;  ///< Empty for standard output.
  std::string waiting_;              ///< Small pieces are written together.
};

/// Writes data that is already complete. Throws FileError.
void write_output(const OutputFile& file, std::string_view text);

/// Writes data to standard output. Throws FileError.
void write_output(std::string_view text);

}  // namespace twrench::system
