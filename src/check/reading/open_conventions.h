#pragma once

#include <vector>

#include "check/conventions/convention.h"
#include "table/reader.h"

namespace twrench::check {

/// Returns every convention that the names of the columns leave open, given what was said: one
/// where nothing is ambiguous, which then has all its columns. Where columns of rates or of an
/// attitude are said, no others are looked for, but for the time. Of Euler angles without a
/// sequence all six that turn about three different axes are returned. Throws ColumnError for a
/// column that the file has not, for a time, a rate or a component that is missing, and where there
/// are neither rates nor an attitude; BadTable where the file states another unit than was said.
std::vector<Convention> conventions(const table::Header& header, const Convention& said);

}  // namespace twrench::check
