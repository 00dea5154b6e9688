#pragma once

#include <cstddef>
#include <string>

#include "table/reader.h"

namespace twrench::check {

/// Returns the index of the column that is called `theirs`; case is ignored if no name matches
/// exactly. "#k" is the k-th column, unless a column has that name. Throws ColumnError about our
/// name `ours` if there is no such column, suggesting the nearest name, or if several columns
/// match.
std::size_t find_column(const table::Header& header, const std::string& ours,
                        const std::string& theirs);

/// Returns the name by which find_column() finds the column: its own, or "#k" if that is empty or
/// another column has it, too.
std::string name_for(const table::Header& header, std::size_t column);

}  // namespace twrench::check
