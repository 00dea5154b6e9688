#pragma once

#include <twrench/base/error.h>

#include <string>
#include <string_view>

namespace twrench::table {

/// A table was read, but its columns or values are unusable. For a file that cannot be read or is
/// not a table, system::FileError is thrown instead.
class BadTable : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

/// A cell that needs a number is empty.
class EmptyCell : public BadTable {
 public:
  using BadTable::BadTable;
};

/// The location of a cell in messages: "run.csv:17: the column 'wx'".
std::string cell_place(const std::string& row_place, const std::string& column);

/// The error for a cell that is not a number.
BadTable no_number(const std::string& row_place, const std::string& column, std::string_view text);

/// The error for a cell that has no calendar time of the kind in the first row.
BadTable no_calendar_time(const std::string& row_place, const std::string& column,
                          std::string_view text);

/// The error for a number beyond the range of doubles.
BadTable too_large(const std::string& row_place, const std::string& column, std::string_view text);

}  // namespace twrench::table
