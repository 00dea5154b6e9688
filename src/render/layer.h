#pragma once

#include "image/image.h"

namespace twrench {

/// Lays `layer` (RGBA, premultiplied: colour times coverage) over `image` (RGB), with the layer's
/// top left pixel at column x and row y. The layer lies inside the image.
void lay_over(Image& image, const Image& layer, int x, int y);

/// The same on nothing: an RGBA image, transparent outside the layer, whose colours are straight:
/// not darkened where the coverage is partial.
Image lay_on_nothing(int width, int height, const Image& layer, int x, int y);

}  // namespace twrench
