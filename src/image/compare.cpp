#include "image/compare.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace twrench {
namespace {

std::uint8_t distance(std::uint8_t a, std::uint8_t b) {
  return static_cast<std::uint8_t>(std::abs(a - b));
}

}  // namespace

std::optional<Difference> compare(const Image& a, const Image& b, int threshold) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) {
    return std::nullopt;
  }
  const auto channels = static_cast<std::size_t>(a.channels);
  Difference difference;
  std::uint64_t sum = 0;
  std::uint64_t over = 0;
  for (std::size_t pixel = 0; pixel < a.pixels.size(); pixel += channels) {
    int largest = 0;
    for (std::size_t i = pixel; i < pixel + channels; ++i) {
      const int d = distance(a.pixels[i], b.pixels[i]);
      sum += static_cast<std::uint64_t>(d);
      largest = std::max(largest, d);
    }
    over += largest > threshold ? 1 : 0;
    difference.max = std::max(difference.max, largest);
  }
  const auto values = static_cast<double>(a.pixels.size());
  difference.mean = static_cast<double>(sum) / values;
  difference.share = static_cast<double>(over) * a.channels / values;
  return difference;
}

Image difference_image(const Image& a, const Image& b) {
  const auto channels = static_cast<std::size_t>(a.channels);
  Image image(a.width, a.height, 3);
  std::uint8_t largest = 1;
  for (std::size_t pixel = 0; pixel * channels < a.pixels.size(); ++pixel) {
    const std::size_t from = pixel * channels;
    const std::uint8_t alpha =
        channels == 4 ? distance(a.pixels[from + 3], b.pixels[from + 3]) : std::uint8_t{0};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint8_t d = std::max(alpha, distance(a.pixels[from + c], b.pixels[from + c]));
      image.pixels[3 * pixel + c] = d;
      largest = std::max(largest, d);
    }
  }
  for (std::uint8_t& value : image.pixels) {
    value = static_cast<std::uint8_t>(value * 255 / largest);
  }
  return image;
}

}  // namespace twrench
