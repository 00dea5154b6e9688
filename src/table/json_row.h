#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "table/reader.h"

namespace twrench::table {

/// A value of a row that is no array and no object.
struct JsonCell {
  enum class Kind { missing, number, too_large, other };

  Kind kind = Kind::missing;
  Number number;
  std::string text;  ///< as it is written, unless it is a number
};

/// Values of a row with the names of their columns: the keys; "#1", "#2" ... of a row that is an
/// array. What lies in arrays and objects within is "X[0]", "X[2][1]", "rates.x".
struct JsonCells {
  std::vector<std::string> names;
  std::vector<JsonCell> cells;
};

/// Reads the text of one row. Throws system::FileError, about `place`, where it is no JSON.
void read_json_row(std::string_view text, const std::string& place, JsonCells& row);

}  // namespace twrench::table
