#pragma once

#include <twrench/body/shape.h>

namespace twrench::picture {

/// How a shape curves near its silhouette, for the width of what it reflects there.
struct OutlineRadii {
  /// Radius of curvature in cm.
  double radius;
  /// The same for a shape with a round outline, else 0.
  double round;
};

/// Returns the radii of a shape, means where they differ from place to place.
OutlineRadii outline_radii(const body::Shape& shape);

}  // namespace twrench::picture
