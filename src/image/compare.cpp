#include "image/compare.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace twrench::image {
namespace {

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

/// Units of `Sample` in one step of 8 bits: 1, or 257 for 16 bits.
template <typename Sample>
constexpr int parts_of_step = std::numeric_limits<Sample>::max() / 255;

/// Sums over the differences of the samples of an image.
class DifferenceSums {
 public:
  DifferenceSums(int channels, int threshold) : channels_(channels), threshold_(threshold) {}

  /// Adds a row; `threshold` is in the units of its samples.
  template <typename Sample>
  void add(int y, std::span<const Sample> row) {
    std::uint32_t sum = 0;  // of at most 4 * 16384 samples of 16 bits
    Sample largest = 0;
    for (const Sample d : row) sum += d;
    for (const Sample d : row) largest = std::max(largest, d);
    sum_ += sum;
    max_ = std::max<int>(max_, largest);
    if (largest > threshold_) count(y, row);
  }

  Difference result(const double values, const int step) const {
    const Area area =
        over_ == 0 ? Area() : Area{left_, top_, right_ + 1 - left_, bottom_ + 1 - top_};
    return {static_cast<double>(max_) / step, static_cast<double>(sum_) / (step * values),
            static_cast<double>(over_) * channels_ / values, area};
  }

 private:
  template <typename Sample>
  void count(int y, std::span<const Sample> row) {
    over_ += channels_ == 3 ? pixels_over<3>(row) : pixels_over<4>(row);
    const auto is_over = [this](Sample d) { return d > threshold_; };
    const auto first = std::ranges::find_if(row, is_over) - row.begin();
    const auto behind = std::find_if(row.rbegin(), row.rend(), is_over).base() - row.begin();
    left_ = std::min(left_, static_cast<int>(first) / channels_);
    right_ = std::max(right_, static_cast<int>(behind - 1) / channels_);
    top_ = std::min(top_, y);
    bottom_ = std::max(bottom_, y);
  }

  /// Has no branches, because it takes most of the time if the images differ much.
  template <std::size_t channels, typename Sample>
  std::uint64_t pixels_over(std::span<const Sample> row) const {
    const auto threshold = static_cast<Sample>(threshold_);
    std::uint32_t over = 0;
    for (const Sample* d = row.data(); d != row.data() + row.size(); d += channels) {
      Sample largest = d[0];
      for (std::size_t c = 1; c < channels; ++c) largest = std::max(largest, d[c]);
      over += largest > threshold ? 1U : 0U;
    }
    return over;
  }

  int channels_;
  int threshold_;
  int max_ = 0;
  std::uint64_t sum_ = 0, over_ = 0;
  int left_ = std::numeric_limits<int>::max(), top_ = left_;
  int right_ = 0, bottom_ = 0;
};

template <typename Sample>
std::optional<Difference> compare_images(const BasicImage<Sample>& a, const BasicImage<Sample>& b,
                                         int threshold, int edges) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) {
    return std::nullopt;
  }
  SampleDifferences<Sample> differences(a, b, edges);
  DifferenceSums sums(a.channels, threshold * parts_of_step<Sample>);
  for (int y = 0; y < a.height; ++y) {
    const std::span<const Sample> row = differences.row(y);
    if (!row.empty()) sums.add(y, row);
  }
  return sums.result(static_cast<double>(a.pixels.size()), parts_of_step<Sample>);
}

/// The value of a channel in the image of differences: that channel's difference or that of alpha,
/// whichever is larger.
template <typename Sample>
int shown_difference(const Sample* pixel, int channels, std::size_t channel) {
  const int d = pixel[channel];
  return channels == 4 ? std::max<int>(d, pixel[3]) : d;
}

template <typename Sample>
Image image_of_difference(const BasicImage<Sample>& a, const BasicImage<Sample>& b, int edges) {
  Image image(a.width, a.height, 3);
  const auto channels = static_cast<std::size_t>(a.channels);
  SampleDifferences<Sample> differences(a, b, edges);
  int largest = 1;
  for (int y = 0; y < a.height; ++y) {
    const std::span<const Sample> row = differences.row(y);
    if (!row.empty()) largest = std::max<int>(largest, *std::ranges::max_element(row));
  }
  for (int y = 0; y < a.height; ++y) {
    const std::span<const Sample> row = differences.row(y);
    if (row.empty()) continue;
    std::uint8_t* shown = &image.pixels[static_cast<std::size_t>(y) * image.row_bytes()];
    for (std::size_t at = 0; at < row.size(); at += channels) {
      for (std::size_t c = 0; c < 3; ++c) {
        *shown++ =
            static_cast<std::uint8_t>(shown_difference(&row[at], a.channels, c) * 255 / largest);
      }
    }
  }
  return image;
}

}  // namespace

std::optional<Difference> compare(const Image& a, const Image& b, int threshold, int edges) {
  return compare_images(a, b, threshold, edges);
}

std::optional<Difference> compare(const DeepImage& a, const DeepImage& b, int threshold,
                                  int edges) {
  return compare_images(a, b, threshold, edges);
}

Image difference_image(const Image& a, const Image& b, int edges) {
  return image_of_difference(a, b, edges);
}

Image difference_image(const DeepImage& a, const DeepImage& b, int edges) {
  return image_of_difference(a, b, edges);
}

}  // namespace twrench::image
