#include "recording/informative_rows.h"

#include <twrench/math/so3.h>

#include <algorithm>
#include <string>

#include "recording/row_decoder.h"

namespace twrench::recording {
namespace {

constexpr std::size_t enough = 128;

/// The stride between the rows that are kept, a power of two.
std::size_t stride_of(const RowSample& numbers, const Convention& convention) {
  std::size_t widest = 1;
  while (enough * widest < numbers.rows.size()) widest *= 2;
  if (has_rates(convention)) return widest;
  const std::vector<Row> rows = decoded(numbers, convention);
  constexpr double near = 0.5;  // rad
  std::size_t stride = 1;
  while (stride < widest && so3::log(rows[0].X.transpose() * rows[2 * stride].X).norm() < near) {
    stride *= 2;
  }
  return stride;
}

}  // namespace

RowSample read_row_sample(const Recording& recording, const Convention& convention) {
  const RowDecoder decoder(recording.header(), convention, [] { return std::string(); });
  const RowSample& numbers = recording.first_rows_of_extract(decoder.columns(), decoder.second());
  const std::size_t stride = stride_of(numbers, convention);
  RowSample kept{numbers.header, numbers.columns, {}, {}};
  for (std::size_t i = 0; i < numbers.rows.size() && kept.rows.size() < enough; i += stride) {
    kept.rows.push_back(numbers.rows[i]);
    kept.places.push_back(numbers.places[i]);
  }
  return kept;
}

std::vector<Row> decoded(const RowSample& numbers, const Convention& convention) {
  std::size_t i = 0;
  RowDecoder decoder(numbers.header, convention, [&] { return numbers.places[i]; });
  std::vector<std::size_t> order;
  for (const std::size_t column : decoder.columns()) {
    const auto found = std::ranges::find(numbers.columns, column);
    order.push_back(static_cast<std::size_t>(found - numbers.columns.begin()));
  }
  std::vector<table::Number> in_order(order.size());
  std::vector<Row> rows(numbers.rows.size());
  for (; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < order.size(); ++k) in_order[k] = numbers.rows[i][order[k]];
    if (i == 0) decoder.set_first_row(in_order);
    decoder.decode(in_order, rows[i]);
  }
  return rows;
}

std::vector<Row> beginning(const Recording& recording, const Convention& convention,
                           std::size_t count) {
  RowReader reader = recording.rows(convention);
  std::vector<Row> rows;
  Row row;
  while (rows.size() < count && reader.next(row)) rows.push_back(row);
  return rows;
}

std::vector<Row> informative_rows(const Recording& recording, const Convention& convention) {
  return decoded(read_row_sample(recording, convention), convention);
}

}  // namespace twrench::recording
