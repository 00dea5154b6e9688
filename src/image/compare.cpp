#include "image/compare.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace twrench::image {
namespace {

int distance(int a, int b) { return std::abs(a - b); }

template <typename Sample>
std::optional<Difference> compare_images(const BasicImage<Sample>& a, const BasicImage<Sample>& b,
                                         int threshold) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) {
    return std::nullopt;
  }
  constexpr int step = std::numeric_limits<Sample>::max() / 255;  // 257 for 16 bits
  const auto channels = static_cast<std::size_t>(a.channels);
  int max = 0;
  std::uint64_t sum = 0;
  std::uint64_t over = 0;
  for (std::size_t pixel = 0; pixel < a.pixels.size(); pixel += channels) {
    int largest = 0;
    for (std::size_t i = pixel; i < pixel + channels; ++i) {
      const int d = distance(a.pixels[i], b.pixels[i]);
      sum += static_cast<std::uint64_t>(d);
      largest = std::max(largest, d);
    }
    over += largest > threshold * step ? 1 : 0;
    max = std::max(max, largest);
  }
  const auto values = static_cast<double>(a.pixels.size());
  return Difference{static_cast<double>(max) / step, static_cast<double>(sum) / (step * values),
                    static_cast<double>(over) * a.channels / values};
}

template <typename Sample>
Image image_of_difference(const BasicImage<Sample>& a, const BasicImage<Sample>& b) {
  const auto channels = static_cast<std::size_t>(a.channels);
  Image image(a.width, a.height, 3);
  const auto difference = [&](std::size_t pixel, std::size_t channel) {
    const std::size_t at = pixel * channels;
    const int alpha = channels == 4 ? distance(a.pixels[at + 3], b.pixels[at + 3]) : 0;
    return std::max(alpha, distance(a.pixels[at + channel], b.pixels[at + channel]));
  };
  int largest = 1;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    largest = std::max(largest, difference(i / 3, i % 3));
  }
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(difference(i / 3, i % 3) * 255 / largest);
  }
  return image;
}

}  // namespace

std::optional<Difference> compare(const Image& a, const Image& b, int threshold) {
  return compare_images(a, b, threshold);
}

std::optional<Difference> compare(const DeepImage& a, const DeepImage& b, int threshold) {
  return compare_images(a, b, threshold);
}

Image difference_image(const Image& a, const Image& b) { return image_of_difference(a, b); }

Image difference_image(const DeepImage& a, const DeepImage& b) { return image_of_difference(a, b); }

}  // namespace twrench::image
