#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace twrench::image
