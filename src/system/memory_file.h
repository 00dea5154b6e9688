#pragma once

#include <string>
#include <string_view>

#include "system/descriptor.h"
#include "system/error.h"

namespace twrench::system {

/// A file without a name, in memory, that a child process can read: it inherits the descriptor.
class MemoryFile {
 public:
  /// Throws FileError.
  explicit MemoryFile(std::string_view text);

  /// Returns the path under which child processes find it.
  std::string path() const;

 private:
  Descriptor descriptor_;
};

}  // namespace twrench::system
