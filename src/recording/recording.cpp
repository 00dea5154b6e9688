#include "recording/recording.h"

#include <algorithm>
#include <utility>

namespace twrench::recording {

const RowSample& Recording::first_rows(const std::vector<std::size_t>& columns) const {
  const auto is_there = [&](std::size_t column) {
    return std::ranges::find(first_rows_.columns, column) != first_rows_.columns.end();
  };
  if (!first_rows_.rows.empty() && std::ranges::all_of(columns, is_there)) return first_rows_;
  constexpr std::size_t most = 4096;
  RowSample sample{header(), columns, {}, {}};
  std::vector<table::Number> row(columns.size());
  table_->begin_pass(columns);
  while (sample.rows.size() < most && table_->next(row)) {
    sample.rows.push_back(row);
    sample.places.push_back(table_->place());
  }
  first_rows_ = std::move(sample);
  return first_rows_;
}

}  // namespace twrench::recording
