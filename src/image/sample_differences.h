#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "image/image.h"

namespace twrench::image {

/// The least and the greatest values around the samples of a row: within `radius` pixels across and
/// down, of the same channel. Beyond the sides of the image there is nothing.
template <typename Sample>
class RowRange {
 public:
  RowRange(const BasicImage<Sample>& image, int radius)
      : image_(image),
        radius_(radius),
        samples_(static_cast<std::size_t>(image.width * image.channels)),
        low_(samples_),
        high_(samples_),
        column_low_(samples_ + 2 * margin()),
        column_high_(samples_ + 2 * margin()) {}

  void move_to(int row) {
    const auto first = static_cast<std::size_t>(std::max(row - radius_, 0));
    const auto last = static_cast<std::size_t>(std::min(row + radius_, image_.height - 1));
    Sample* const low = &column_low_[margin()];
    Sample* const high = &column_high_[margin()];
    std::copy_n(&image_.pixels[first * samples_], samples_, low);
    std::copy_n(low, samples_, high);
    for (std::size_t y = first + 1; y <= last; ++y) {
      const Sample* const samples = &image_.pixels[y * samples_];
      for (std::size_t i = 0; i < samples_; ++i) low[i] = std::min(low[i], samples[i]);
      for (std::size_t i = 0; i < samples_; ++i) high[i] = std::max(high[i], samples[i]);
    }
    repeat_ends(column_low_);
    repeat_ends(column_high_);
    std::copy_n(column_low_.data(), samples_, low_.data());
    std::copy_n(column_high_.data(), samples_, high_.data());
    const auto channels = static_cast<std::size_t>(image_.channels);
    for (std::size_t offset = channels; offset <= 2 * margin(); offset += channels) {
      const Sample* const lows = &column_low_[offset];
      const Sample* const highs = &column_high_[offset];
      for (std::size_t i = 0; i < samples_; ++i) low_[i] = std::min(low_[i], lows[i]);
      for (std::size_t i = 0; i < samples_; ++i) high_[i] = std::max(high_[i], highs[i]);
    }
  }

  /// By how much a sample is outside of the range there.
  Sample distance(std::size_t at, Sample value) const {
    return static_cast<Sample>(std::max(low_[at], value) - std::min(high_[at], value));
  }

 private:
  std::size_t margin() const { return static_cast<std::size_t>(radius_ * image_.channels); }

  /// The outermost pixels are in every range that reaches beyond them, and change nothing there.
  void repeat_ends(std::vector<Sample>& padded) const {
    const auto channels = static_cast<std::size_t>(image_.channels);
    for (std::size_t i = margin(); i-- > 0;) padded[i] = padded[i + channels];
    for (std::size_t i = padded.size() - margin(); i < padded.size(); ++i) {
      padded[i] = padded[i - channels];
    }
  }

  const BasicImage<Sample>& image_;
  const int radius_;
  const std::size_t samples_;  ///< Of a row.
  std::vector<Sample> low_, high_;
  std::vector<Sample> column_low_, column_high_;  ///< With a margin at either end.
};

/// The differences of the samples of two images of one size, row by row, with the tolerance for
/// edges that compare() describes.
template <typename Sample>
class SampleDifferences {
 public:
  SampleDifferences(const BasicImage<Sample>& a, const BasicImage<Sample>& b, int edges)
      : a_(a),
        b_(b),
        edges_(edges),
        range_of_a_(a, edges),
        range_of_b_(b, edges),
        row_(a.row_bytes() / sizeof(Sample)) {}

  /// Returns those of a row, valid until the next call; nothing if all are zero.
  std::span<const Sample> row(int y) {
    const std::size_t samples = row_.size();
    const Sample* const a = &a_.pixels[static_cast<std::size_t>(y) * samples];
    const Sample* const b = &b_.pixels[static_cast<std::size_t>(y) * samples];
    if (std::memcmp(a, b, samples * sizeof(Sample)) == 0) return {};
    if (edges_ == 0) {
      for (std::size_t i = 0; i < samples; ++i) {
        row_[i] = static_cast<Sample>(std::max(a[i], b[i]) - std::min(a[i], b[i]));
      }
      return row_;
    }
    range_of_a_.move_to(y);
    range_of_b_.move_to(y);
    for (std::size_t i = 0; i < samples; ++i) {
      row_[i] = std::max(range_of_b_.distance(i, a[i]), range_of_a_.distance(i, b[i]));
    }
    return row_;
  }

 private:
  const BasicImage<Sample>& a_;
  const BasicImage<Sample>& b_;
  const int edges_;
  RowRange<Sample> range_of_a_, range_of_b_;
  std::vector<Sample> row_;
};

}  // namespace twrench::image
