#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "check/conventions/convention.h"
#include "check/reading/row.h"
#include "table/reader.h"

namespace twrench::check {

/// Evenly spread rows from the beginning of a file, enough to test the physics
/// (check/verdict/physics.h): the numbers as the file writes them, in the columns that a convention
/// names.
struct RowSample {
  table::Header header;
  std::vector<std::size_t> columns;
  std::vector<std::vector<table::Number>> rows;
  std::vector<std::string> places;  ///< of the rows in the file, for messages
};

/// Reads such rows. If there are only attitudes, consecutive ones are close enough to determine the
/// rotation between them. Throws as RowReader does.
RowSample read_row_sample(const std::filesystem::path& file, const Convention& convention);

/// Decodes the numbers in a convention that has the same columns in any order. Throws
/// table::BadTable for numbers that the convention does not allow.
std::vector<Row> decoded(const RowSample& numbers, const Convention& convention);

/// Reads and decodes the rows in the same convention.
std::vector<Row> informative_rows(const std::filesystem::path& file, const Convention& convention);

}  // namespace twrench::check
