#pragma once

#include <optional>

#include "table/input.h"

namespace twrench::table {

/// Converts a file of one JSON object that has its rows in a member, or its columns as arrays of
/// the same length, to one object or array a line in memory. Returns nothing for other files, and
/// for those beyond 64 MiB.
std::optional<Input> rows_of_object(const Input& input);

}  // namespace twrench::table
