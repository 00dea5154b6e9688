#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "system/error.h"

namespace twrench::mesh {

/// A text that is read line by line, and each line word by word.
class Lines {
 public:
  /// The text must outlive it. `name` is what messages call it.
  Lines(std::string name, std::string_view text) : name_(std::move(name)), rest_(text) {}

  /// Goes to the next line; false where there is none.
  bool next();

  /// Takes the next word of the line; empty at its end.
  std::string_view word();

  /// Takes the next word as a finite number. Throws system::FileError where it is none, and
  /// InvalidArgument where it is not finite.
  double number();

  /// What has not been read: the lines after this one.
  std::string_view rest() const { return rest_; }

  /// Where the line stands, as messages say it: "a.obj:17".
  std::string place() const { return place(line_number_); }
  std::string place(std::size_t line_number) const;

  std::size_t line_number() const { return line_number_; }

  /// The error for a line that breaks the rules of its format.
  system::FileError bad(const std::string& why) const { return {place(), why}; }

 private:
  std::string name_;
  std::string_view rest_;
  std::string_view line_;
  std::size_t line_number_ = 0;
};

/// What is shown of a text in a message: a word may be as long as a file.
std::string shown(std::string_view text);

}  // namespace twrench::mesh
