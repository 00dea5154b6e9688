#include "check/verdict/error_history.h"

#include <algorithm>

namespace twrench::check {
namespace {

void merge(Span& span, const Span& next) {
  span.last = next.last;
  span.rate_error = std::max(span.rate_error, next.rate_error);
  span.attitude_error = std::max(span.attitude_error, next.attitude_error);
  span.rodrigues_length = std::max(span.rodrigues_length, next.rodrigues_length);
  span.rate_differences.add(next.rate_differences);
  span.attitude_differences.add(next.attitude_differences);
}

}  // namespace

void ErrorHistory::add(const Span& row) {
  if (!spans_.empty() && rows_in_last_ < rows_per_span_) {
    merge(spans_.back(), row);
    ++rows_in_last_;
    return;
  }
  if (spans_.size() == most) {
    for (std::size_t i = 0; i < most / 2; ++i) {
      merge(spans_[2 * i], spans_[2 * i + 1]);
      spans_[i] = spans_[2 * i];
    }
    spans_.resize(most / 2);
    rows_per_span_ *= 2;
  }
  spans_.push_back(row);
  rows_in_last_ = 1;
}

DifferenceSums sums(const std::vector<Span>& spans, DifferenceSums Span::*kind, std::size_t begin,
                    std::size_t end) {
  DifferenceSums total;
  for (std::size_t i = begin; i < end; ++i) total.add(spans[i].*kind);
  return total;
}

}  // namespace twrench::check
