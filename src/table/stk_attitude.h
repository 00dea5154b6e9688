#pragma once

#include <string>
#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins like a file of STK.
bool is_of_stk(std::string_view start);

/// A table in memory.
struct StkTable {
  Input input;
  std::string sequence;  ///< of Euler angles, "zyx"; empty without
};

/// Converts an attitude file of STK to a table in memory that has the same lines: names for the
/// keyword of the data, and comments for the other keywords. Throws system::FileError if it is cut
/// off or has attitudes that are not read.
StkTable table_of_stk(const Input& input);

}  // namespace twrench::table
