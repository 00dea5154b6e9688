#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "table/reader.h"

namespace twrench::table {

/// A value of a row, neither an array nor an object.
struct JsonCell {
  enum class Kind { missing, number, too_large, other };

  Kind kind = Kind::missing;
  Number number;
  std::string text;  ///< as it is written, unless it is a number
};

/// The values of a row with the names of their columns: the keys, or "#1", "#2" ... if the row is
/// an array. Values in nested arrays and objects are named "X[0]", "X[2][1]", "rates.x".
struct JsonCells {
  std::vector<std::string> names;
  std::vector<JsonCell> cells;
};

/// Reads the text of one row. Throws system::FileError, about `place`, if it is not JSON.
void read_json_row(std::string_view text, const std::string& place, JsonCells& row);

}  // namespace twrench::table
