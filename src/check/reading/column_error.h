#pragma once

#include <string>
#include <utility>

#include "table/error.h"

namespace twrench::check {

/// The columns that are wanted do not fit those that the file has: one is missing, given twice, or
/// left open. The remedy lists the file's columns.
class ColumnError : public table::BadTable {
 public:
  /// `column` is ours ("wz"), or empty where it is no single one.
  ColumnError(const std::string& file, std::string column, const std::string& why,
              const std::string& remedy)
      : BadTable(file, why, remedy), column_(std::move(column)) {}

  const std::string& column() const noexcept { return column_; }

 private:
  std::string column_;
};

}  // namespace twrench::check
