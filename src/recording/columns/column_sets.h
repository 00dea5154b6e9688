#pragma once

#include <cstddef>
#include <vector>

#include "recording/conventions/names.h"
#include "table/reader.h"

namespace twrench::recording {

/// The columns of a file that together give one quantity, such as the rates.
struct ColumnSet {
  Kind kind;
  std::vector<std::size_t> columns;  ///< in the order of names_of(kind)
  bool in_space = false;             ///< whether the names place the rates in space axes
  bool is_weak = false;              ///< whether the names have other usual meanings
};

/// Whether a set that lacks a column is an error: rates without one may be read without an
/// attitude.
enum class Incomplete { refused, ignored };

/// Finds the columns of a kind by their names, and returns every set that the names allow. Our own
/// names take precedence over all others. Throws ColumnError if the only set is incomplete and that
/// is refused, or if two columns could be the same component.
std::vector<ColumnSet> find_sets(const table::Header& header, Kind kind,
                                 Incomplete incomplete = Incomplete::refused);

/// Returns the rates in a file of a gyroscope whose columns say no more than x, y, z, or xyz[0] to
/// xyz[2], or gx, gy, gz: names that only mean rates if the file has nothing else. Throws
/// ColumnError if two columns have one name.
std::vector<ColumnSet> find_bare_rates(const table::Header& header);

/// Returns the quaternion in columns that say no more than x, y, z and w, as three.js names them.
/// Throws ColumnError if two columns have one name.
std::vector<ColumnSet> find_bare_quaternions(const table::Header& header);

/// Returns the sets that these columns may form if their names leave the order open: a quaternion
/// has its scalar first or last, a matrix its entries by rows or by columns, and Euler angles begin
/// with yaw or with roll.
std::vector<ColumnSet> orders_of(Kind kind, const std::vector<std::size_t>& columns);

/// Lists the file's columns for a remedy: "its columns are: time, p, q, r", or the first of many.
std::string columns_remedy(const table::Header& header);

}  // namespace twrench::recording
