#pragma once

#include <vector>

namespace twrench::image {

/// A rectangle of an image: columns from x, rows from y, counted from the top left, in pixels.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const Area&) const = default;
};

/// Returns the intersection; if it is empty, its width and height are 0.
Area common(const Area& a, const Area& b);

/// Returns the smallest area that contains both.
Area around(const Area& a, const Area& b);

/// Returns areas that cover all of `areas`. Two overlapping areas are merged if their bounding
/// rectangle is no larger than both together.
std::vector<Area> merged(std::vector<Area> areas);

}  // namespace twrench::image
