#pragma once

#include "image/area.h"

namespace twrench::picture {

// Each of these cuts a piece of the given size in pixels, and a gap next to it, off one side of
// `rest`, and returns the piece. The size of `rest` may become negative.
image::Area cut_top(image::Area& rest, int height, int gap);
image::Area cut_bottom(image::Area& rest, int height, int gap);
image::Area cut_left(image::Area& rest, int width, int gap);
image::Area cut_right(image::Area& rest, int width, int gap);

/// Returns the largest centred square.
image::Area centred_square(const image::Area& area);

/// One cell of an area divided into equal parts.
struct Share {
  /// The cell.
  image::Area area;
  /// Its position in the grid.
  int column, row;
};

/// Returns the cells of a grid, row by row. Inner edges divide `middle` evenly; outer edges are
/// those of `whole`, which contains it.
std::vector<Share> shares(const image::Area& whole, const image::Area& middle, int columns,
                          int rows);

}  // namespace twrench::picture
