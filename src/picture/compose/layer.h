#pragma once

#include <vector>

#include "image/area.h"
#include "image/image.h"

namespace twrench::picture {

/// An image to be composited over another: RGBA with premultiplied alpha.
struct Layer {
  /// The pixels.
  image::Image image;
  /// Position of its top left pixel.
  int x = 0, y = 0;

  image::Area area() const { return {x, y, image.width, image.height}; }
};

/// Returns a transparent layer for the part of `picture` within `margin` px of `area`.
Layer layer_around(const image::Area& area, int margin, const image::Area& picture);

/// Copies the pixels in `area`, as far as it lies in both, between two layers at the same position.
void copy_area(const Layer& from, Layer& to, const image::Area& area);

/// Multiplies the layer's opacity by a factor from 0 to 1.
void scale_opacity(Layer& layer, double factor);

/// Composites `layer` over `image`, which is RGB or premultiplied RGBA. The layer should lie inside
/// the image; parts outside are a bug of the caller and are clipped. Returns the affected areas.
std::vector<image::Area> composite_over(image::Image& image, const Layer& layer);

/// Converts premultiplied to unpremultiplied alpha in `area`.
void unpremultiply(image::Image& image, const image::Area& area);

}  // namespace twrench::picture
