#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace twrench::image {

/// An sRGB image with rows from the top left and no padding. Three channels are RGB; four are RGBA
/// with unpremultiplied alpha.
template <typename Sample>
struct BasicImage {
  /// Width in pixels.
  int width = 0;
  /// Height in pixels.
  int height = 0;
  /// Number of channels, 3 or 4.
  int channels = 3;
  /// The samples, row by row with interleaved channels.
  std::vector<Sample> pixels;

  BasicImage() = default;
  BasicImage(int w, int h, int c)
      : width(w),
        height(h),
        channels(c),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
               static_cast<std::size_t>(c)) {}

  std::size_t row_bytes() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels) * sizeof(Sample);
  }
};

using Image = BasicImage<std::uint8_t>;
using DeepImage = BasicImage<std::uint16_t>;  ///< The full precision of PNG files.

/// Returns whether an image has an alpha channel whose values are all the largest.
template <typename Sample>
bool has_opaque_alpha(const BasicImage<Sample>& image) {
  if (image.channels != 4) return false;
  for (std::size_t at = 3; at < image.pixels.size(); at += 4) {
    if (image.pixels[at] != std::numeric_limits<Sample>::max()) return false;
  }
  return true;
}

/// Converts RGBA to RGB.
template <typename Sample>
void drop_alpha(BasicImage<Sample>& image) {
  const std::size_t count = image.pixels.size() / 4;
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    for (std::size_t c = 0; c < 3; ++c) image.pixels[3 * pixel + c] = image.pixels[4 * pixel + c];
  }
  image.pixels.resize(3 * count);
  image.channels = 3;
}

/// Copies the colours of invisible pixels, whose alpha is 0 in both RGBA images of the same size.
/// Returns whether any of them differed.
template <typename Sample>
bool copy_hidden_colors(const BasicImage<Sample>& from, BasicImage<Sample>& to) {
  bool did_differ = false;
  for (std::size_t at = 0; at < from.pixels.size(); at += 4) {
    if (from.pixels[at + 3] != 0 || to.pixels[at + 3] != 0) continue;
    for (std::size_t c = at; c < at + 3; ++c) {
      did_differ = did_differ || to.pixels[c] != from.pixels[c];
      to.pixels[c] = from.pixels[c];
    }
  }
  return did_differ;
}

/// Returns what ordered dithering adds to a value before it is rounded to the nearest integer: half
/// steps up and down in a 2 x 2 pattern. Quarter steps are fine enough to hide bands, and a pattern
/// this short costs a PNG file half as much as noise.
inline float dither(int x, int y) {
  static constexpr std::array pattern{-0.375F, 0.125F, 0.375F, -0.125F};
  return pattern[static_cast<std::size_t>(y % 2 * 2 + x % 2)];
}

}  // namespace twrench::image
