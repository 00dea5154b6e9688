#include "recording/filled_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace twrench::recording {

FilledRows::FilledRows(std::unique_ptr<table::Reader> table) : table_(std::move(table)) {
  header_ = table_->header();
}

void FilledRows::begin_pass(std::span<const std::size_t> columns) {
  columns_.assign(columns.begin(), columns.end());
  has_begun_ = has_ended_ = false;
  at_start_ = at_end_ = {};
  error_.reset();
  table_->begin_pass(columns);
}

/// Reads the next row, and returns the error if it lacks a number.
std::optional<table::BadTable> FilledRows::error_of_next(std::span<table::Number> numbers) {
  try {
    has_ended_ = !table_->next(numbers);
  } catch (const table::EmptyCell& error) {
    return error;
  }
  if (has_ended_) return {};
  const auto nan = std::ranges::find_if(
      numbers, [](const table::Number& number) { return std::isnan(number.value); });
  if (nan == numbers.end()) return {};
  const std::size_t column = columns_[static_cast<std::size_t>(nan - numbers.begin())];
  return table::BadTable(table::cell_place(place(), header_.names[column]), "nan is not finite",
                         "remove the row, or truncate the file before it");
}

bool FilledRows::next(std::span<table::Number> numbers) {
  while (!has_ended_) {
    const auto error = error_of_next(numbers);
    if (!error) break;
    Rows& rows = has_begun_ ? at_end_ : at_start_;
    if (rows.first.empty()) rows.first = place();
    rows.last = place();
    if (!error_) error_ = error;
  }
  if (has_ended_ && has_begun_) return false;
  if (has_ended_) {
    if (error_) throw *error_;
    return false;
  }
  if (has_begun_ && error_) throw *error_;
  has_begun_ = true;
  error_.reset();
  return true;
}

std::string FilledRows::left_out() const {
  const auto text = [](const Rows& rows) {
    return rows.first == rows.last ? rows.first : fmt::format("{} to {}", rows.first, rows.last);
  };
  const std::string start = text(at_start_), end = text(at_end_);
  return start.empty() || end.empty() ? start + end : start + ", " + end;
}

}  // namespace twrench::recording
