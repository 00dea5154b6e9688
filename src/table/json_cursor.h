#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Splits a JSON text into values that are small enough for memory. Their contents are left to a
/// parser.
class JsonCursor {
 public:
  /// Longer values are not rows of a table.
  static constexpr std::size_t max_bytes = 1 << 20;
  /// The deepest nesting of arrays and objects in a value.
  static constexpr int max_depth = 8;

  /// Begins after a byte order mark, if there is one.
  explicit JsonCursor(const Input& input);

  /// Skips white space, and returns the next character without taking it; nothing at the end.
  std::optional<char> peek();

  /// Takes the next character, whatever it is.
  void take();

  /// Takes the next character if it is `wanted`, and returns whether it is.
  bool take_if(char wanted);

  /// Takes the next character, which must be `wanted`. Throws system::FileError.
  void expect(char wanted);

  /// Takes one value as it is written, and sets line() to where it begins. Throws system::FileError
  /// if the value is too long, nested too deeply, or not complete.
  std::string_view take_value();

  /// Line of the value taken last, from 1.
  std::size_t line() const { return line_; }

  /// "run.json:17", for messages about the value taken last.
  std::string place() const;

  /// "run.json:17", for messages about the next character.
  std::string place_here() const;

 private:
  bool fill();
  bool has_next() { return at_ < buffer_.size() || fill(); }
  void take_scalar();
  void take_nested();
  void take_string();
  void append_and_take();

  const Input* input_;
  std::string_view buffer_;
  Window window_;
  std::size_t at_ = 0;
  std::uint64_t offset_ = 0;  ///< of the input after the buffer
  std::size_t lines_ = 1;     ///< begun so far
  std::size_t line_ = 1;
  std::string value_;
};

}  // namespace twrench::table
