#include "recording/rows.h"

namespace twrench::recording {

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
