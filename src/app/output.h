#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/pending_file.h"

namespace twrench {

/// A command's data on its way to a file, which then holds all of it or nothing, or to standard
/// output for "-". Piece by piece, so that no more than a piece is ever held.
class Output {
 public:
  /// Throws FileError.
  explicit Output(const std::string& path);

  /// Throws FileError.
  void write(std::string_view text);

  /// To be called once, after the last piece: without it a file keeps its old content. Throws
  /// FileError.
  void finish();

 private:
  void pass_on();

  std::optional<PendingFile> file_;  ///< else standard output
  std::string waiting_;              ///< small pieces are passed on together
};

/// The same for data that is there already.
void write_output(const std::string& path, std::string_view text);

}  // namespace twrench
