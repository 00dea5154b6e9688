#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "table/error.h"
#include "table/reader.h"

namespace twrench::recording {

/// The requested columns do not match those of the file: one is missing, given twice, or ambiguous.
/// The remedy usually lists the file's columns.
class ColumnError : public table::BadTable {
 public:
  /// `column` is our name of the column ("wz"), or empty if the error is not about a single one.
  ColumnError(const std::string& file, std::string column, const std::string& why,
              const std::string& remedy)
      : BadTable(file, why, remedy), column_(std::move(column)) {}

  /// The columns that may be meant, although their names do not say so, are `suggested`:
  /// "wx=x,wy=y,wz=z".
  ColumnError(const std::string& file, std::string suggested, const std::string& why)
      : BadTable(file, why, "if they are meant, give these columns: " + suggested),
        suggested_(std::move(suggested)) {}

  const std::string& column() const noexcept { return column_; }
  const std::string& suggested() const noexcept { return suggested_; }

 private:
  std::string column_, suggested_;
};

/// Returns the index of the column that is called `theirs`; case is ignored if no name matches
/// exactly. "#k" is the k-th column, unless a column has that name. Throws ColumnError about our
/// name `ours` if there is no such column, suggesting the nearest name, or if several columns
/// match.
std::size_t find_column(const table::Header& header, const std::string& ours,
                        const std::string& theirs);

/// Returns the name by which find_column() finds the column: its own, or "#k" if that is empty or
/// another column has it, too.
std::string name_for(const table::Header& header, std::size_t column);

}  // namespace twrench::recording
