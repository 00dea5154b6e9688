#pragma once

#include <string_view>

#include "system/descriptor.h"
#include "system/error.h"

namespace twrench::system {

/// A file without a name, in memory, that one child process can read: it inherits the descriptor.
class MemoryFile {
 public:
  /// Throws FileError.
  explicit MemoryFile(std::string_view text);

  /// Returns the descriptor, which is at the start of the text.
  int descriptor() const { return descriptor_.get(); }

 private:
  Descriptor descriptor_;
};

}  // namespace twrench::system
