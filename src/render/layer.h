#pragma once

#include "image/area.h"
#include "image/image.h"

namespace twrench {

/// A picture to be laid over another: RGBA, premultiplied (colour times coverage).
struct Layer {
  Image image;
  int x = 0, y = 0;  ///< where its top left pixel goes

  Area area() const { return {x, y, image.width, image.height}; }
};

/// Lays `layer`, which lies inside, over `image`: RGB, or RGBA that is premultiplied too.
void lay_over(Image& image, const Layer& layer);

/// From premultiplied to straight alpha: colours are not darkened where the coverage is partial.
void make_straight(Image& image, const Area& area);

}  // namespace twrench
