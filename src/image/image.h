#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace twrench {

/// An image, sRGB, rows from the top left, no padding. 3 channels are RGB, 4 are RGBA with straight
/// (not premultiplied) alpha.
template <typename Sample>
struct BasicImage {
  int width = 0;
  int height = 0;
  int channels = 3;
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
using DeepImage = BasicImage<std::uint16_t>;  ///< as finely as a PNG file can tell

}  // namespace twrench
