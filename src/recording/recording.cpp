#include "recording/recording.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace twrench::recording {
namespace {

constexpr std::size_t most = 4096;

}  // namespace

const RowSample& Recording::first_rows(const std::vector<std::size_t>& columns) const {
  const auto is_there = [&](std::size_t column) {
    return std::ranges::find(first_rows_.columns, column) != first_rows_.columns.end();
  };
  if (!first_rows_.rows.empty() && std::ranges::all_of(columns, is_there)) return first_rows_;
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

const RowSample& Recording::first_rows_of_extract(const std::vector<std::size_t>& columns,
                                                  double second) const {
  if (extract_ == Extract()) return first_rows(columns);
  RowSample& sample = first_rows_of_extract_;
  if (sample.columns == columns && second_ == second) return sample;
  sample = {header(), columns, {}, {}};
  second_ = second;
  table_->begin_pass(columns);
  std::vector<table::Number> row(columns.size());
  std::optional<table::Number> start;
  while (sample.rows.size() < most && table_->next(row)) {
    if (!start) start = row.front();
    const double t =
        second * ((row.front().value - start->value) + (row.front().rest - start->rest));
    if (t > extract_.to) break;
    if (t < extract_.from) continue;
    sample.rows.push_back(row);
    sample.places.push_back(table_->place());
  }
  return sample;
}

}  // namespace twrench::recording
