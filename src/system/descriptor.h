#pragma once

#include <unistd.h>

#include <string>
#include <string_view>
#include <utility>

#include "system/error.h"

namespace twrench::system {

/// Owns a file descriptor; -1 means none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  Descriptor(Descriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }

  /// Closes the descriptor. Returns false and sets errno if the system reports that not all data
  /// was written.
  bool close() {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor < 0 || ::close(descriptor) == 0;
  }

 private:
  int descriptor_ = -1;
};

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
