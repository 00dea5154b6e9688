#pragma once

namespace twrench {

/// A rectangle of an image: columns from x, rows from y, counted from the top left.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const Area&) const = default;
};

}  // namespace twrench
