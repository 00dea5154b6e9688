#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "image/image.h"

namespace twrench::image {

/// A gradient and some noise, so that every filter and the compressor have something to do.
inline Image sample_image(int width, int height, int channels, unsigned seed) {
  Image image(width, height, channels);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = static_cast<std::uint8_t>(i / 50 + random() % 3);
  }
  return image;
}

}  // namespace twrench::image
