#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/allowance.h"

namespace twrench::mesh {

/// The direction in which a path turns.
enum class Turn { left, straight, right };

/// Returns the direction in which the path from `a` via `b` to `c` turns; straight if the turn is
/// within round-off.
Turn turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// Splits a polygon in the plane, counter-clockwise, at its diagonals (G. H. Meisters, "Polygons
/// have ears", 1975). Corners may lie on an edge between others or coincide with them, so a hole
/// may be joined to the outline by an edge that is traversed both ways. Returns triangles as
/// indices of corners, two fewer than there are corners; they are counter-clockwise or without
/// area. Returns nothing if the polygon cannot be split, because it crosses itself, or if the
/// allowance is used up. The polygon must have at least three corners.
std::optional<std::vector<std::array<std::uint32_t, 3>>> clip_ears(
    std::span<const Eigen::Vector2d> polygon, Allowance& allowance);

}  // namespace twrench::mesh
