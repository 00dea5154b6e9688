#pragma once

#include <optional>
#include <string>
#include <vector>

#include "table/input.h"

namespace twrench::table {

/// Rows in memory, and what else a JSON object states.
struct JsonRows {
  Input rows;                         ///< one object or array a line
  std::vector<std::string> preamble;  ///< members that are numbers: "fps: 50"
};

/// Converts a file of one JSON object that has its rows in a member, or its columns as arrays of
/// the same length. Returns nothing for other files, and for those beyond 64 MiB.
std::optional<JsonRows> rows_of_object(const Input& input);

}  // namespace twrench::table
