#pragma once

#include <string>
#include <utility>

#include "table/error.h"

namespace twrench::check {

/// The requested columns do not match those of the file: one is missing, given twice, or ambiguous.
/// The remedy usually lists the file's columns.
class ColumnError : public table::BadTable {
 public:
  /// `column` is our name of the column ("wz"), or empty if the error is not about a single one.
  ColumnError(const std::string& file, std::string column, const std::string& why,
              const std::string& remedy)
      : BadTable(file, why, remedy), column_(std::move(column)) {}

  const std::string& column() const noexcept { return column_; }

 private:
  std::string column_;
};

}  // namespace twrench::check
