#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "mesh/allowance.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {

/// Returns how often the triangles accepted by `counts` wind around a point: 1 inside a closed
/// surface, 0 outside it, and the sum for several surfaces. Nothing if the point is on the surface.
/// Deducts the work from the allowance.
std::optional<int> winding_number(const TriangleTree& tree, const Eigen::Vector3d& point,
                                  const std::function<bool(std::uint32_t triangle)>& counts,
                                  Allowance& allowance);

}  // namespace twrench::mesh
