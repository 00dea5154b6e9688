#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "image/image.h"

namespace twrench::image {

/// The least and the greatest value around each sample of a row: of the same channel, within
/// `radius` pixels across and down, inside the image.
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
      widen(&image_.pixels[y * samples_], &image_.pixels[y * samples_], low, high);
    }
    repeat_ends(column_low_);
    repeat_ends(column_high_);
    std::copy_n(column_low_.data(), samples_, low_.data());
    std::copy_n(column_high_.data(), samples_, high_.data());
    const auto channels = static_cast<std::size_t>(image_.channels);
    for (std::size_t offset = channels; offset <= 2 * margin(); offset += channels) {
      widen(&column_low_[offset], &column_high_[offset], low_.data(), high_.data());
    }
  }

  const Sample* low() const { return low_.data(); }
  const Sample* high() const { return high_.data(); }

 private:
  /// Extends the range of each sample by another range. The arguments are not members: a written
  /// byte could be part of a member, which would then be read again for each sample.
  void widen(const Sample* lows, const Sample* highs, Sample* low, Sample* high) const {
    const std::size_t samples = samples_;
    for (std::size_t i = 0; i < samples; ++i) low[i] = std::min(low[i], lows[i]);
    for (std::size_t i = 0; i < samples; ++i) high[i] = std::max(high[i], highs[i]);
  }

  std::size_t margin() const { return static_cast<std::size_t>(radius_ * image_.channels); }

  /// The outermost pixels are in every range that reaches beyond them, so that repeating them
  /// changes no range.
  void repeat_ends(std::vector<Sample>& padded) const {
    const auto channels = static_cast<std::size_t>(image_.channels);
    for (std::size_t i = margin(); i-- > 0;) padded[i] = padded[i + channels];
    for (std::size_t i = padded.size() - margin(); i < padded.size(); ++i) {
      padded[i] = padded[i - channels];
    }
  }

  const BasicImage<Sample>& image_;
  const int radius_;
  const std::size_t samples_;  ///< Number in a row.
  std::vector<Sample> low_, high_;
  std::vector<Sample> column_low_, column_high_;  ///< With a margin at each end.
};

/// The differences of the samples of two images of the same size, row by row, with the tolerance
/// for edges that compare() describes.
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

  /// Returns the differences in a row, valid until the next call; nothing if all are zero.
  std::span<const Sample> row(int y) {
    const std::size_t samples = row_.size();
    const Sample* const a = &a_.pixels[static_cast<std::size_t>(y) * samples];
    const Sample* const b = &b_.pixels[static_cast<std::size_t>(y) * samples];
    if (std::memcmp(a, b, samples * sizeof(Sample)) == 0) return {};
    std::ranges::fill(row_, Sample{0});
    if (edges_ == 0) {
      add_distances(a, b, b, row_.data());
      return row_;
    }
    range_of_a_.move_to(y);
    range_of_b_.move_to(y);
    add_distances(a, range_of_b_.low(), range_of_b_.high(), row_.data());
    add_distances(b, range_of_a_.low(), range_of_a_.high(), row_.data());
    return row_;
  }

 private:
  /// Raises each value of `row` to the distance of `value` from its range, if that is larger.
  void add_distances(const Sample* value, const Sample* low, const Sample* high,
                     Sample* row) const {
    const std::size_t samples = row_.size();
    for (std::size_t i = 0; i < samples; ++i) {
      const int distance = std::max(low[i], value[i]) - std::min(high[i], value[i]);
      row[i] = std::max(row[i], static_cast<Sample>(distance));
    }
  }

  const BasicImage<Sample>& a_;
  const BasicImage<Sample>& b_;
  const int edges_;
  RowRange<Sample> range_of_a_, range_of_b_;
  std::vector<Sample> row_;
};

}  // namespace twrench::image
