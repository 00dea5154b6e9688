#pragma once

#include <cstddef>
#include <vector>

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

}  // namespace twrench::check
