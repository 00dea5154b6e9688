#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "system/error.h"
#include "table/error.h"
#include "table/reader.h"

namespace twrench::table {

/// A table in memory: all columns, or those selected by index.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
};

inline Table read_table(std::string_view bytes, std::vector<std::size_t> columns = {}) {
  const auto reader = open_table("run", bytes);
  Table table{reader->header().names, {}};
  if (columns.empty()) {
    for (std::size_t i = 0; i < table.names.size(); ++i) columns.push_back(i);
  }
  reader->begin_pass(columns);
  std::vector<Number> numbers(columns.size());
  while (reader->next(numbers)) {
    std::vector<double>& row = table.rows.emplace_back();
    for (const Number& number : numbers) row.push_back(number.value);
  }
  return table;
}

/// The message and remedy of the error of this kind, in one line; "no error" if there is none.
template <typename Kind>
std::string error_of(std::string_view bytes, const std::vector<std::size_t>& columns = {}) {
  try {
    read_table(bytes, columns);
  } catch (const Kind& error) {
    return std::string(error.what()) + " -- " + error.remedy();
  }
  return "no error";
}

/// The error of a file that cannot be read.
inline std::string file_error_of(std::string_view bytes) {
  return error_of<system::FileError>(bytes);
}

/// The error of a table that is unusable.
inline std::string table_error_of(std::string_view bytes) { return error_of<BadTable>(bytes); }

}  // namespace twrench::table
