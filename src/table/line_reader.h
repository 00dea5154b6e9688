#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "table/input.h"

namespace twrench::table {

/// Reads a text line by line, in memory for one line.
class LineReader {
 public:
  /// Longer lines are not rows of a table.
  static constexpr std::size_t max_bytes = 1 << 20;

  /// Begins after a byte order mark, if there is one.
  explicit LineReader(const Input& input);

  /// Reads the next line, without its end (LF or CR LF); it is valid until the next call. Returns
  /// false at the end. Throws system::FileError for a line that is longer than max_bytes.
  bool next(std::string_view& line);

  /// Number of the line read last, from 1.
  std::size_t number() const { return number_; }

  /// Location of the line read last: "run.csv:17".
  std::string place() const;

 private:
  bool refill();

  const Input* input_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  ///< the unread part of the buffer
  std::uint64_t offset_ = 0;         ///< of the input after the buffer
  std::size_t number_ = 0;
};

/// Length of the UTF-8 byte order mark at the beginning of the text: 3 or 0.
std::size_t byte_order_mark(std::string_view text);

}  // namespace twrench::table
