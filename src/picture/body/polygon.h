#pragma once

#include <cstdint>

namespace twrench::picture {

/// Triangulates the flat polygon with vertices first to last, which is counter-clockwise as seen
/// from outside, or clockwise, into triangles as fat as possible; a fan would consist of slivers.
/// Calls `add(a, b, c)` for each triangle.
template <typename Add>
void fill_polygon(std::uint32_t first, std::uint32_t last, bool clockwise, const Add& add) {
  if (last - first < 2) return;
  const std::uint32_t middle = first + (last - first) / 2;
  add(first, clockwise ? last : middle, clockwise ? middle : last);
  fill_polygon(first, middle, clockwise, add);
  fill_polygon(middle, last, clockwise, add);
}

}  // namespace twrench::picture
