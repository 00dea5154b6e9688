#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "check/conventions/convention.h"
#include "check/reading/row.h"
#include "table/reader.h"

namespace twrench::check {

/// Evenly spread rows of the beginning of a file, enough to test the physics
/// (check/verdict/physics.h), as their numbers stand there, in the columns that a convention names.
struct TellingNumbers {
  table::Header header;
  std::vector<std::size_t> columns;
  std::vector<std::vector<table::Number>> rows;
};

/// Reads them. Of attitudes alone, consecutive ones are near enough to tell the turn between them.
/// Throws as RowReader does.
TellingNumbers telling_numbers(const std::filesystem::path& file, const Convention& convention);

/// Returns the rows of the numbers in a convention of the same columns, in whatever order. Throws
/// table::BadTable for numbers that it does not allow.
std::vector<Row> decoded(const TellingNumbers& numbers, const Convention& convention);

/// The two together.
std::vector<Row> telling_rows(const std::filesystem::path& file, const Convention& convention);

}  // namespace twrench::check
