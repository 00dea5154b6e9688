#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "table/dialect.h"

namespace twrench::table {

/// The names and units that a text file gives its columns.
struct CsvHeader {
  std::vector<std::string> names;  ///< "#1", "#2" ... if the file has none and is no message of ROS
  std::vector<std::string> units;  ///< of each column; or empty
  /// Index of the first row among the lines of the sample; their number if there are no rows.
  std::size_t first_row = 0;
};

/// Whether the cells below the names are units rather than a row: none is a number, except for the
/// 1 of a quantity without a unit.
bool are_units(std::span<const std::string_view> cells);

/// Puts the names of groups before names, from the first that occurs twice on: "Rotation: X",
/// "Position: X". The groups are in the lines before the names that have as many cells; an empty
/// cell belongs to the group before it. Does nothing if the names then still occur twice.
void add_groups(const std::vector<std::string>& lines, char separator,
                std::vector<std::string>& names);

/// Finds the header: the first line if it has names in columns of numbers, or else the last comment
/// that has a name for each column. A line below the names may have the units. Requires a line.
CsvHeader find_csv_header(const Sample& sample, char separator);

}  // namespace twrench::table
