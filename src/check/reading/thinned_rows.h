#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "check/conventions/convention.h"
#include "check/reading/row.h"

namespace twrench::check {

/// Evenly spread rows of a file of any length: the first and every 2^k-th after it.
class ThinnedRows {
 public:
  /// Keeps at most `most` rows; `most` must be even.
  explicit ThinnedRows(std::size_t most) : most_(most) {}

  void add(const Row& row);
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::size_t most_;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
  std::vector<Row> rows_;
};

/// Returns at most `most` of the first `of` rows, evenly spread. Throws as RowReader does.
std::vector<Row> thinned_rows(const std::filesystem::path& file, const Convention& convention,
                              std::size_t most, std::size_t of);

}  // namespace twrench::check
