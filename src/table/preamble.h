#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "table/input.h"

namespace twrench::table {

/// Finds the lines before the names of the columns that are no comments: those up to "endheader" or
/// "End_of_Header", "sep=;" of spreadsheets, and others before a line of names that is followed by
/// rows: lines with another number of cells, or with the names of groups of columns. Returns none
/// if the file begins with names or rows.
std::vector<std::string> find_preamble(const Input& input);

}  // namespace twrench::table
