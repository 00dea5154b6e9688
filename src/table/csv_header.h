#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "table/dialect.h"

namespace twrench::table {

/// The names and units that a text file gives its columns.
struct CsvHeader {
  std::vector<std::string> names;  ///< "#1", "#2" ... if the file has none
  std::vector<std::string> units;  ///< of each column; or empty
  /// Index of the first row among the lines of the sample; their number if there are no rows.
  std::size_t first_row = 0;
};

/// Finds the header: the first line if it has names in columns of numbers, or else the last comment
/// that has a name for each column. A line below the names may have the units. Requires a line.
CsvHeader find_csv_header(const Sample& sample, char separator);

}  // namespace twrench::table
