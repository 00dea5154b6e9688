#include "image/compare.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>
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

namespace {

constexpr double samples_of_window = similarity_window * similarity_window;

/// A type that represents every sum over a window, and its square, exactly.
template <typename Sample>
using Sum = std::conditional_t<sizeof(Sample) == 1, std::int32_t, double>;

/// The smallest rectangle with all pixels that differ.
template <typename Sample>
Area changed_area(const BasicImage<Sample>& a, const BasicImage<Sample>& b) {
  const auto samples = static_cast<std::ptrdiff_t>(a.row_bytes() / sizeof(Sample));
  std::ptrdiff_t left = samples, right = 0;
  int top = a.height, bottom = 0;
  for (int y = 0; y < a.height; ++y) {
    const auto begin = a.pixels.begin() + y * samples, end = begin + samples;
    const auto other = b.pixels.begin() + y * samples;
    const auto first = std::mismatch(begin, end, other).first;
    if (first == end) continue;
    const auto last =
        std::mismatch(std::make_reverse_iterator(end), std::make_reverse_iterator(begin),
                      std::make_reverse_iterator(other + samples));
    left = std::min(left, first - begin);
    right = std::max(right, last.first.base() - begin);
    top = std::min(top, y);
    bottom = y + 1;
  }
  if (bottom == 0) return {};
  const auto pixel = [&](std::ptrdiff_t sample) { return static_cast<int>(sample / a.channels); };
  return {pixel(left), top, pixel(right - 1) + 1 - pixel(left), bottom - top};
}

/// The windows, given by their first pixels, that contain a pixel of the area.
Area windows_over(const Area& area, int width, int height) {
  constexpr int around = similarity_window - 1;
  return common({area.x - around, area.y - around, area.width + around, area.height + around},
                {0, 0, width - around, height - around});
}

/// Sums over the windows whose first pixels are in one row, which moves down the images. The sums
/// of a window's columns are kept, so that the cost of a row does not depend on the size of a
/// window.
template <typename Sample>
class WindowRow {
 public:
  WindowRow(const BasicImage<Sample>& a, const BasicImage<Sample>& b, const Area& windows)
      : a_(a),
        b_(b),
        channels_(static_cast<std::size_t>(a.channels)),
        first_(static_cast<std::size_t>(windows.x) * channels_),
        windows_(static_cast<std::size_t>(windows.width) * channels_),
        columns_(windows_ + (similarity_window - 1) * channels_),
        mean_a_(columns_),
        mean_b_(columns_),
        squares_(columns_),
        products_(columns_) {
    for (int y = 0; y < similarity_window - 1; ++y) add<1>(windows.y + y);
  }

  /// Adds the similarity of each window in row `y` to `totals`. Rows must be requested in order.
  void add_similarities(int y, std::vector<double>& totals) {
    add<1>(y + similarity_window - 1);
    constexpr double range = std::numeric_limits<Sample>::max(), n = samples_of_window;
    // The paper's constants, times the factor by which the sums have not been divided.
    constexpr double c1 = (0.01 * range) * (0.01 * range) * n * n;
    constexpr double c2 = (0.03 * range) * (0.03 * range) * n * (n - 1);
    for (std::size_t i = 0; i < windows_; ++i) {
      const Sum<Sample> a = over_window(mean_a_, i), b = over_window(mean_b_, i);
      const Sum<Sample> means = 2 * a * b, mean_squares = a * a + b * b;
      const Sum<Sample> covariance =
          2 * similarity_window * similarity_window * over_window(products_, i) - means;
      const Sum<Sample> variances =
          similarity_window * similarity_window * over_window(squares_, i) - mean_squares;
      totals[i] += (means + c1) * (covariance + c2) / ((mean_squares + c1) * (variances + c2));
    }
    add<-1>(y);
  }

 private:
  template <int sign>
  void add(int y) {
    const std::size_t at = static_cast<std::size_t>(y * a_.width) * channels_ + first_;
    const Sample* const row_a = &a_.pixels[at];
    const Sample* const row_b = &b_.pixels[at];
    for (std::size_t i = 0; i < columns_; ++i) {
      const Sum<Sample> a = row_a[i], b = row_b[i];
      mean_a_[i] += sign * a;
      mean_b_[i] += sign * b;
      squares_[i] += sign * (a * a + b * b);
      products_[i] += sign * (a * b);
    }
  }

  Sum<Sample> over_window(const std::vector<Sum<Sample>>& columns, std::size_t first) const {
    const Sum<Sample>* const c = &columns[first];
    const std::size_t n = channels_;
    return c[0] + c[n] + c[2 * n] + c[3 * n] + c[4 * n] + c[5 * n] + c[6 * n];
  }

  const BasicImage<Sample>& a_;
  const BasicImage<Sample>& b_;
  const std::size_t channels_;
  const std::size_t first_;  ///< Index of a sample in its row.
  const std::size_t windows_, columns_;
  std::vector<Sum<Sample>> mean_a_, mean_b_, squares_, products_;
};

/// Computes only windows in which the images differ, because the similarity of all others is 1.
template <typename Sample>
double similarity_of(const BasicImage<Sample>& a, const BasicImage<Sample>& b) {
  if (std::min(a.width, a.height) < similarity_window) {
    throw InvalidArgument("structural similarity",
                          fmt::format("it needs at least {0}x{0} pixels, but there are {1}x{2}",
                                      similarity_window, a.width, a.height));
  }
  const Area windows = windows_over(changed_area(a, b), a.width, a.height);
  if (windows.height == 0) return 1.0;
  std::vector<double> totals(static_cast<std::size_t>(windows.width * a.channels));
  WindowRow<Sample> row(a, b, windows);
  for (int y = windows.y; y < windows.y + windows.height; ++y) row.add_similarities(y, totals);
  const double total = std::accumulate(totals.begin(), totals.end(), 0.0);
  const double computed = static_cast<double>(totals.size()) * windows.height;
  const double all = static_cast<double>(a.width - similarity_window + 1) *
                     (a.height - similarity_window + 1) * a.channels;
  return 1.0 - (computed - total) / all;
}

}  // namespace

double structural_similarity(const Image& a, const Image& b) { return similarity_of(a, b); }

double structural_similarity(const DeepImage& a, const DeepImage& b) { return similarity_of(a, b); }

}  // namespace twrench::image
