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

/// A clear one of what lies in `picture` no farther than `reach` px from `area`.
Layer layer_around(const Area& area, int reach, const Area& picture);

/// Lays `layer` over `image`: RGB, or RGBA that is premultiplied too. It lies inside: what does not
/// is a mistake of whoever made it, and is cut off. Returns where it lies.
Area lay_over(Image& image, const Layer& layer);

/// From premultiplied to straight alpha: colours are not darkened where the coverage is partial.
void make_straight(Image& image, const Area& area);

}  // namespace twrench
