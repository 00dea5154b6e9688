#pragma once

#include <vector>

#include "recording/conventions/convention.h"
#include "recording/recording.h"
#include "recording/rows.h"

namespace twrench::recording {

/// Selects evenly spread rows from the beginning of a recording, enough to test the physics
/// (check/verdict/physics.h). If there are only attitudes, consecutive ones are close enough to
/// determine the rotation between them. Throws as RowReader does.
RowSample read_row_sample(const Recording& recording, const Convention& convention);

/// Decodes the numbers in a convention that has the same columns in any order. Throws
/// table::BadTable for numbers that the convention does not allow.
std::vector<Row> decoded(const RowSample& numbers, const Convention& convention);

/// At most `count` rows from the beginning. Throws as RowReader does.
std::vector<Row> beginning(const Recording& recording, const Convention& convention,
                           std::size_t count);

/// Selects and decodes the rows in the same convention.
std::vector<Row> informative_rows(const Recording& recording, const Convention& convention);

}  // namespace twrench::recording
