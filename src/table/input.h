#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "system/descriptor.h"

namespace twrench::table {

/// The bytes of a regular file, or of memory, read piece by piece.
class Input {
 public:
  /// Opens the file. Throws system::FileError if that fails or it is not a regular file, because a
  /// pipe delivers its bytes only once, and a device may never end. Throws InvalidArgument for "-".
  explicit Input(const std::filesystem::path& path);

  /// The bytes must outlive the input.
  Input(std::string name, std::string_view bytes);

  /// Shares the bytes.
  Input(std::string name, std::shared_ptr<const std::string> bytes);

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }

  /// Copies up to `length` bytes from `offset` on, and returns how many: fewer only at the end.
  /// Throws system::FileError if the file cannot be read, or its size has changed by the end.
  std::size_t read(std::uint64_t offset, char* to, std::size_t length) const;

 private:
  void require_unchanged() const;

  std::string name_;
  std::uint64_t size_ = 0;
  system::Descriptor file_;
  std::shared_ptr<const std::string> shared_;
  std::string_view bytes_;
};

/// A part of an input that is kept in memory and moves to the requested bytes.
class Window {
 public:
  explicit Window(const Input& input) : input_(&input) {}

  /// Returns the `length` bytes at `offset`, or fewer if the input ends before. Valid until the
  /// next call.
  std::string_view at(std::uint64_t offset, std::size_t length);

 private:
  const Input* input_;
  std::vector<char> buffer_;
  std::uint64_t begin_ = 0;
  std::size_t filled_ = 0;
};

}  // namespace twrench::table
