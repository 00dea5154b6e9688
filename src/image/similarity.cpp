#include "image/similarity.h"

#include <fmt/format.h>
#include <twrench/base/error.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <vector>

#include "image/area.h"

namespace twrench::image {
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
