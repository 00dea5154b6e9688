#include "recording/rows.h"

namespace twrench::recording {

std::vector<double> derivative_weights(std::span<const double> times) {
  std::vector<double> weights(times.size(), 0.0);
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] == 0) continue;
    weights[k] = 1 / times[k];
    for (std::size_t other = 0; other < times.size(); ++other) {
      if (other != k && times[other] != 0) weights[k] *= times[other] / (times[other] - times[k]);
    }
  }
  return weights;
}

void ThinnedRows::add(const Row& row) {
  if (seen_++ % stride_ != 0) return;
  if (rows_.size() == most_) {
    for (std::size_t i = 0; 2 * i < most_; ++i) rows_[i] = rows_[2 * i];
    rows_.resize(most_ / 2);
    stride_ *= 2;
    if ((seen_ - 1) % stride_ != 0) return;
  }
  rows_.push_back(row);
}

}  // namespace twrench::recording
