#pragma once

#include <cstdint>

namespace twrench {

/// Fills the flat polygon of the vertices first, first + 1, ..., last, which turns
/// counter-clockwise seen from outside or clockwise, with triangles as fat as can be: a fan would
/// be all slivers. `add(a, b, c)` takes each.
template <typename Add>
void fill_polygon(std::uint32_t first, std::uint32_t last, bool clockwise, const Add& add) {
  if (last - first < 2) return;
  const std::uint32_t middle = first + (last - first) / 2;
  add(first, clockwise ? last : middle, clockwise ? middle : last);
  fill_polygon(first, middle, clockwise, add);
  fill_polygon(middle, last, clockwise, add);
}

}  // namespace twrench
