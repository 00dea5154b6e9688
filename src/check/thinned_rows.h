#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "check/convention.h"
#include "check/row.h"
#include "table/reader.h"

namespace twrench::check {

/// Evenly spread rows of a file of any length: every 2^k-th, the first among them.
template <typename RowType>
class ThinnedRows {
 public:
  /// Keeps at most `most` rows, which must be even.
  explicit ThinnedRows(std::size_t most) : most_(most) {}

  void add(const RowType& row) {
    if (seen_++ % stride_ != 0) return;
    if (rows_.size() == most_) {
      for (std::size_t i = 0; 2 * i < most_; ++i) rows_[i] = rows_[2 * i];
      rows_.resize(most_ / 2);
      stride_ *= 2;
      if ((seen_ - 1) % stride_ != 0) return;
    }
    rows_.push_back(row);
  }
  const std::vector<RowType>& rows() const { return rows_; }

 private:
  std::size_t most_;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
  std::vector<RowType> rows_;
};

/// Returns at most `most` of the first `of` rows, evenly spread. Throws as RowReader does.
std::vector<Row> thinned_rows(const std::filesystem::path& file, const Convention& convention,
                              std::size_t most, std::size_t of);

/// Returns rows of the beginning of the file, enough to test the physics (check/physics.h). Throws
/// as RowReader does.
std::vector<Row> telling_rows(const std::filesystem::path& file, const Convention& convention);

/// The numbers of those rows as they stand in the file, in the columns that a convention names.
struct TellingNumbers {
  table::Header header;
  std::vector<std::size_t> columns;
  std::vector<std::vector<table::Number>> rows;
};
TellingNumbers telling_numbers(const std::filesystem::path& file, const Convention& convention);

}  // namespace twrench::check
