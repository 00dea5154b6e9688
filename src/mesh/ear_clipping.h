#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/allowance.h"

namespace twrench::mesh {

/// Which way a path turns.
enum class Turn { left, straight, right };

/// Returns which way the path from `a` over `b` to `c` turns; straight where it does within
/// round-off.
Turn turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// Splits a polygon in the plane, counter-clockwise, at its diagonals (G. H. Meisters, "Polygons
/// have ears", 1975). Corners may lie on the edge between others or in one place with them, so that
/// a hole may be joined to the outline by an edge to and fro. Returns two triangles fewer than
/// there are corners, counter-clockwise or without area, as indices of corners; nothing where that
/// is not possible, because the polygon crosses itself, or where the allowance is used up. It must
/// have three corners at least.
std::optional<std::vector<std::array<std::uint32_t, 3>>> clip_ears(
    std::span<const Eigen::Vector2d> polygon, Allowance& allowance);

}  // namespace twrench::mesh
