#pragma once

#include <cstddef>
#include <string>

#include "table/reader.h"

namespace twrench::check {

/// Returns the index of the column that is called `theirs`, in whatever letters, or is the k-th
/// where that is "#k". Throws ColumnError about our name `ours` where there is none, with the
/// nearest name suggested, or where several are called so.
std::size_t find_column(const table::Header& header, const std::string& ours,
                        const std::string& theirs);

/// The name by which find_column() finds the column: its own, or "#k" where another has it too.
std::string name_for(const table::Header& header, std::size_t column);

}  // namespace twrench::check
