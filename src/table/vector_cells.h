#pragma once

#include <optional>

#include "table/input.h"

namespace twrench::table {

/// Converts a text with vectors in its cells, such as "(0.1, 0.2, 0.3)" or [0.1 0.2 0.3], to a
/// table in memory that has the same lines, but a column for each of the 3, 4 or 9 numbers:
/// "rotation[0]", "rotation[1]" ... Returns nothing if the first rows have none.
std::optional<Input> table_of_vector_cells(const Input& input);

}  // namespace twrench::table
