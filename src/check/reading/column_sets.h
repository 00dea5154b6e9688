#pragma once

#include <cstddef>
#include <vector>

#include "check/conventions/names.h"
#include "table/reader.h"

namespace twrench::check {

/// The columns of a file that tell something together.
struct ColumnSet {
  Kind kind;
  std::vector<std::size_t> columns;  ///< in the order of names_of(kind)
  bool in_space = false;             ///< the names say that the rates are in space axes
};

/// Finds the columns of a kind by their names: all the sets that the names leave open. Our own
/// names come before any others. Throws ColumnError where only some of a set are there, or two
/// could be the same one.
std::vector<ColumnSet> find_sets(const table::Header& header, Kind kind);

/// The sets that columns of a kind can be whose order their names do not tell: a quaternion has its
/// scalar first or last, a matrix its entries by rows or by columns.
std::vector<ColumnSet> orders_of(Kind kind, const std::vector<std::size_t>& columns);

/// "the file has: time, p, q, r", or the first names of many.
std::string columns_remedy(const table::Header& header);

}  // namespace twrench::check
