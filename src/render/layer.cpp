#include "render/layer.h"

#include <algorithm>

namespace twrench {
namespace {

std::size_t offset_of(const Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * image.row_bytes() +
         static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels);
}

/// value / 255, rounded, for 0 <= value <= 255 * 255.
unsigned divide_by_255(unsigned value) { return (value + 128 + ((value + 128) >> 8)) >> 8; }

}  // namespace

void lay_over(Image& image, const Image& layer, int x, int y) {
  const std::uint8_t* in = layer.pixels.data();
  for (int row = 0; row < layer.height; ++row) {
    std::uint8_t* out = image.pixels.data() + offset_of(image, x, y + row);
    for (int column = 0; column < layer.width; ++column, in += 4, out += 3) {
      const unsigned through = 255U - in[3];
      for (int c = 0; c < 3; ++c) {
        const unsigned sum = in[c] + divide_by_255(out[c] * through);
        out[c] = static_cast<std::uint8_t>(std::min(sum, 255U));
      }
    }
  }
}

Image lay_on_nothing(int width, int height, const Image& layer, int x, int y) {
  Image image(width, height, 4);
  const std::uint8_t* in = layer.pixels.data();
  for (int row = 0; row < layer.height; ++row) {
    std::uint8_t* out = image.pixels.data() + offset_of(image, x, y + row);
    for (int column = 0; column < layer.width; ++column, in += 4, out += 4) {
      const unsigned alpha = in[3];
      if (alpha == 0) continue;
      for (int c = 0; c < 3; ++c) {
        const unsigned straight = (in[c] * 255U + alpha / 2) / alpha;
        out[c] = static_cast<std::uint8_t>(std::min(straight, 255U));
      }
      out[3] = in[3];
    }
  }
  return image;
}

}  // namespace twrench
