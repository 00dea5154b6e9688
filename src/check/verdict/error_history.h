#pragma once

#include <cstddef>
#include <vector>

#include "check/verdict/noise.h"
#include "recording/rows.h"

namespace twrench::check {

/// The errors of consecutive rows.
struct Span {
  recording::Row last;          ///< the last of the rows
  double rate_error = 0;        ///< largest, rad/s
  double attitude_error = 0;    ///< largest, rad
  double rodrigues_length = 0;  ///< largest Row::rodrigues_length
  DifferenceSums rate_differences = {}, attitude_differences = {};
  double rate_limit = 0;      ///< resolution limit at the last row, rad/s
  double attitude_limit = 0;  ///< likewise, rad
};

/// The errors of any number of rows against time, in at most `most` spans of equally many rows
/// each.
class ErrorHistory {
 public:
  static constexpr std::size_t most = 1024;

  /// Adds the next row, given as a span of one row.
  void add(const Span& row);

  std::vector<Span>& spans() { return spans_; }

 private:
  std::size_t rows_per_span_ = 1;
  std::size_t rows_in_last_ = 0;
  std::vector<Span> spans_;
};

/// Returns the sums of the spans from index `begin` to `end`, of rates or of attitudes.
DifferenceSums sums(const std::vector<Span>& spans, DifferenceSums Span::*kind, std::size_t begin,
                    std::size_t end);

}  // namespace twrench::check
