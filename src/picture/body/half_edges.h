#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace twrench::picture {

/// Marks an edge without a second triangle.
inline constexpr std::uint32_t no_half_edge = std::numeric_limits<std::uint32_t>::max();

/// Returns the half-edge that follows in the same triangle. Half-edge 3 t + k leads from corner k
/// of triangle t to the next corner.
inline std::uint32_t next_half_edge(std::uint32_t half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

/// Returns, for each half-edge of triangles with three corners each, the one between the same
/// corners in the opposite direction, or `no_half_edge`. If more than two triangles meet at an
/// edge, each half-edge is paired with the earliest unpaired one. Corners are numbers below
/// `count`. The time is linear, except for corners in which many triangles meet.
std::vector<std::uint32_t> opposite_half_edges(std::span<const std::uint32_t> corners,
                                               std::size_t count);

/// Returns for each of `count` elements the first one that is equal to it; `less(i, j)` orders
/// them.
template <typename Less>
std::vector<std::uint32_t> first_equal(std::size_t count, const Less& less) {
  std::vector<std::uint32_t> order(count), first(count);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    return less(i, j) || (!less(j, i) && i < j);
  });
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_new = k == 0 || less(order[k - 1], order[k]);
    first[order[k]] = is_new ? order[k] : first[order[k - 1]];
  }
  return first;
}

}  // namespace twrench::picture
