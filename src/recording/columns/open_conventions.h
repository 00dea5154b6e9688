#pragma once

#include <vector>

#include "recording/conventions/convention.h"
#include "table/reader.h"

namespace twrench::recording {

/// Returns every convention that the names of the columns and `said`, the convention as far as the
/// user gave it, leave open. Each names all its columns; if nothing is ambiguous, there is only
/// one. If rate or attitude columns are given explicitly, only the time column is detected
/// automatically. For Euler angles without a sequence, all six sequences that turn about three
/// different axes are returned. Throws ColumnError if a given column does not exist, if the time, a
/// rate or a component is missing, and if there are neither rates nor an attitude; BadTable if the
/// file states another unit than the user.
std::vector<Convention> conventions(const table::Header& header, const Convention& said);

}  // namespace twrench::recording
