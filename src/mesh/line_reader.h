#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "system/error.h"

namespace twrench::mesh {

/// Reads a text line by line and each line word by word.
class LineReader {
 public:
  /// The text must outlive this object. `name` identifies it in messages.
  LineReader(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {}

  /// Advances to the next line; returns false if there is none.
  bool next();

  /// Reads the next word of the line; empty at its end.
  std::string_view word();

  /// Reads the next word as a finite number. Throws system::FileError if it is not a number, and
  /// InvalidArgument if it is not finite.
  double number();

  /// Returns the unread text, the lines after the current one.
  std::string_view rest() const { return rest_; }

  /// Returns the place of the current line for messages: "a.obj:17".
  std::string place() const { return place(line_number_); }
  std::string place(std::size_t line_number) const;

  std::size_t line_number() const { return line_number_; }

  /// Returns the error for a line that violates its format.
  system::FileError bad(const std::string& why) const { return {place(), why}; }

 private:
  std::string name_;
  std::string_view rest_;
  std::string_view line_;
  std::size_t line_number_ = 0;
};

/// Returns a text as messages quote it, shortened, because a word may be as long as a file.
std::string shown(std::string_view text);

}  // namespace twrench::mesh
