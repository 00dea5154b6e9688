#include "image/compare.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "image/sample_differences.h"

namespace twrench::image {
namespace {

/// Of a step of 8 bits; 257 for 16 bits.
template <typename Sample>
constexpr int parts_of_step = std::numeric_limits<Sample>::max() / 255;

/// Sums over the differences of the samples of an image.
class DifferenceSums {
 public:
  DifferenceSums(int channels, int threshold)
      : channels_(static_cast<std::size_t>(channels)), threshold_(threshold) {}

  /// Adds a row; `threshold` is in the units of its samples.
  template <typename Sample>
  void add(int y, std::span<const Sample> row) {
    std::uint64_t sum = 0;
    for (const Sample d : row) sum += d;
    sum_ += sum;
    const int largest = *std::ranges::max_element(row);
    max_ = std::max(max_, largest);
    if (largest > threshold_) count(y, row);
  }

  Difference result(const double values, const int step) const {
    const Area area =
        over_ == 0 ? Area() : Area{left_, top_, right_ + 1 - left_, bottom_ + 1 - top_};
    return {static_cast<double>(max_) / step, static_cast<double>(sum_) / (step * values),
            static_cast<double>(over_) * static_cast<double>(channels_) / values, area};
  }

 private:
  template <typename Sample>
  void count(int y, std::span<const Sample> row) {
    int first = std::numeric_limits<int>::max(), last = 0, x = 0;
    for (std::size_t at = 0; at < row.size(); at += channels_, ++x) {
      bool is_over = false;
      for (std::size_t c = 0; c < channels_; ++c) is_over |= row[at + c] > threshold_;
      if (!is_over) continue;
      ++over_;
      first = std::min(first, x);
      last = x;
    }
    left_ = std::min(left_, first);
    right_ = std::max(right_, last);
    top_ = std::min(top_, y);
    bottom_ = std::max(bottom_, y);
  }

  std::size_t channels_;
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

/// A pixel of the image of differences: the channels of colour, each at least that of alpha.
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
