#pragma once

#include <vector>

namespace twrench {

/// A rectangle of an image: columns from x, rows from y, counted from the top left.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;

  bool operator==(const Area&) const = default;
};

/// What lies in both; without width or height, which are then 0, where nothing does.
Area common(const Area& a, const Area& b);

/// Areas that cover all of `areas`: of those that overlap, two become the one around both where
/// that is no larger than the two together.
std::vector<Area> merged(std::vector<Area> areas);

}  // namespace twrench
