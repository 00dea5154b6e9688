#pragma once

#include <array>
#include <cstddef>

namespace twrench::image {

/// Returns what ordered dithering adds to a value before it is rounded to the nearest integer: half
/// steps up and down in a 2 x 2 pattern. Quarter steps are fine enough to hide bands, and a pattern
/// this short costs a PNG file half as much as noise.
inline float dither(int x, int y) {
  static constexpr std::array pattern{-0.375F, 0.125F, 0.375F, -0.125F};
  return pattern[static_cast<std::size_t>(y % 2 * 2 + x % 2)];
}

}  // namespace twrench::image
