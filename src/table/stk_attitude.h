#pragma once

#include <string_view>

#include "table/input.h"

namespace twrench::table {

/// Whether the text begins like a file of STK.
bool is_of_stk(std::string_view start);

/// Converts an attitude file of STK with quaternions or matrices to a table in memory that has the
/// same lines: names for the keyword of the data, and comments for the other keywords. Throws
/// system::FileError if it is cut off or has other attitudes.
Input table_of_stk(const Input& input);

}  // namespace twrench::table
