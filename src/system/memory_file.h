#pragma once

#include <string>
#include <string_view>

#include "system/descriptor.h"
#include "system/error.h"

namespace twrench::system {

/// A file without a name, in memory, that a child process can read or write through the descriptor
/// that it inherits.
class MemoryFile {
 public:
  /// Creates a file with the text. Throws FileError.
  explicit MemoryFile(std::string_view text);

  /// Returns the descriptor, which is at the start of the text.
  int descriptor() const { return descriptor_.get(); }

  /// Returns the whole contents, for example the output of a child that has ended. Throws
  /// FileError.
  std::string contents() const;

 private:
  Descriptor descriptor_;
};

}  // namespace twrench::system
