#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "table/input.h"

namespace twrench::table {

/// The separators that a file may have. Blanks come last, because they may follow the others.
inline constexpr std::array separators{'\t', ';', '|', ',', ' '};

/// How a text file writes its cells.
struct Dialect {
  char separator = ',';        ///< ' ' if runs of blanks and tabs separate cells
  bool decimal_comma = false;  ///< 1,5 is 3/2
};

/// The beginning of a text file.
struct Sample {
  struct Line {
    std::string text;
    std::size_t number;  ///< in the file, from 1
  };

  std::vector<Line> lines;            ///< neither blank nor a comment
  std::vector<std::string> comments;  ///< the last ones before them, without their marks
  /// Whether a line that begins with a semicolon is a comment. Otherwise its first cell is empty.
  bool semicolon_marks_comment = true;
};

/// Whether the line has no cells: it is blank, or a comment, which begins with #, %, // or, if
/// `semicolon_marks_comment`, a semicolon.
bool is_blank_or_comment(std::string_view line, bool semicolon_marks_comment);

/// Reads the beginning of the file after the first `skipped` lines. Throws system::FileError.
Sample read_sample(const Input& input, std::size_t skipped);

/// Finds the dialect in which the most lines have as many cells as the first and, among equals, the
/// largest share of cells are numbers. Throws system::FileError if numbers such as 1,234 can be
/// read in two ways.
Dialect detect_dialect(const Sample& sample, const std::string& file);

/// Splits a line at the separator, and removes blanks and quotation marks around the cells. Between
/// blanks, a date such as 01 Jan 2026 12:00:00 is one cell. Returns false if a quotation mark is
/// not closed.
bool split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Whether the text is a number, with a decimal point or a decimal comma.
bool is_numeric(std::string_view cell);

}  // namespace twrench::table
