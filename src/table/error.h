#pragma once

#include <twrench/base/error.h>

#include <string>
#include <string_view>

namespace twrench::table {

/// A table that was read, but whose columns or values do not serve. What cannot be read at all, or
/// is no table, is a system::FileError.
class BadTable : public InvalidArgument {
 public:
  using InvalidArgument::InvalidArgument;
};

/// Where a cell stands, as messages name it: "run.csv:17: the column 'wx'".
std::string cell_place(const std::string& row_place, const std::string& column);

/// The error for a cell that is no number: a text, or nothing.
BadTable no_number(const std::string& row_place, const std::string& column, std::string_view text);

/// The error for a number beyond all doubles.
BadTable too_large(const std::string& row_place, const std::string& column, std::string_view text);

}  // namespace twrench::table
