#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "system/error.h"

namespace twrench::mesh {

/// Reads a text line by line and each line word by word. Lines end with LF, CR LF or, if the text
/// has no LF, with CR.
class LineReader {
 public:
  /// The text must outlive this object. `name` identifies it in messages.
  LineReader(std::string name, std::string_view text);

  /// Advances to the next line; returns false if there is none.
  bool next();

  /// Advances to the next statement of a format in which a backslash at the end of a line continues
  /// it and '#' begins a comment. A line with a comment is not continued. Returns false if there is
  /// none.
  bool next_statement();

  /// Reads the next word of the line; empty at its end.
  std::string_view word();

  /// Reads the next word as a finite number. Throws system::FileError if it is not a number, and
  /// InvalidArgument if it is not finite.
  double number();

  /// Returns the unread text, the lines after the current one.
  std::string_view rest() const { return rest_; }

  /// Returns the place of the current line, or of the first line of the current statement, for
  /// messages: "a.obj:17".
  std::string place() const { return place(line_number_); }
  std::string place(std::size_t line_number) const;

  std::size_t line_number() const { return line_number_; }

  /// Returns the error for a line that violates its format.
  system::FileError bad(const std::string& why) const { return {place(), why + note_on_end()}; }

  /// Returns the end of a message about the current line: that the file is probably cut off if the
  /// line is its last one and has no line end, and nothing otherwise.
  std::string note_on_end() const;

 private:
  bool is_continuation(std::size_t index) const;

  std::string name_;
  char line_end_;
  bool is_last_line_open_;
  std::string_view rest_;
  /// The unread part of the current line or statement.
  std::string_view line_;
  std::size_t line_number_ = 0;
  std::size_t lines_read_ = 0;
};

/// Returns a text as messages quote it, shortened, because a word may be as long as a file.
std::string shown(std::string_view text);

}  // namespace twrench::mesh
