#pragma once

#include "image/area.h"

namespace twrench {

// Each cuts a piece of that size in pixels, and a gap next to it, off one side of `rest`, and
// returns the piece. The size of `rest` may become negative.
Area cut_top(Area& rest, int height, int gap);
Area cut_bottom(Area& rest, int height, int gap);
Area cut_left(Area& rest, int width, int gap);
Area cut_right(Area& rest, int width, int gap);

/// Returns the largest centred square.
Area middle_square(const Area& area);

/// One cell of an area divided into equal parts.
struct Share {
  /// The cell.
  Area area;
  /// Its position in the grid.
  int column, row;
};

/// Returns the cells of a grid, row by row. Inner edges divide `middle` evenly; outer edges are
/// those of `whole`, which contains it.
std::vector<Share> shares(const Area& whole, const Area& middle, int columns, int rows);

}  // namespace twrench
