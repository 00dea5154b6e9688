#pragma once

#include <cstddef>
#include <limits>

#include "image/image.h"

namespace twrench::image {

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

}  // namespace twrench::image
