#pragma once

#include "image/area.h"

namespace twrench {

// Each takes a piece of that length, in pixels, off one side of `rest`, and a gap off beside it.
// What is left of `rest` may be less than nothing.
Area cut_top(Area& rest, int height, int gap);
Area cut_bottom(Area& rest, int height, int gap);
Area cut_left(Area& rest, int width, int gap);
Area cut_right(Area& rest, int width, int gap);

/// The largest square in the middle of it.
Area middle_square(const Area& area);

/// One of the equal parts into which an area is cut.
struct Share {
  Area area;
  int column, row;
};

/// In `rows` of `columns` each, row by row. Inner edges share `middle` evenly; outer ones are those
/// of `whole`, which holds it.
std::vector<Share> shares(const Area& whole, const Area& middle, int columns, int rows);

}  // namespace twrench
