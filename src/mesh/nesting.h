#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "mesh/allowance.h"
#include "mesh/topology.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {

/// Returns how often the triangles accepted by `counts` wind around a point: 1 inside a closed
/// surface, 0 outside it, and the sum for several surfaces. Nothing if the point is on the surface.
/// Deducts the work from the allowance.
std::optional<int> winding_number(const TriangleTree& tree, const Eigen::Vector3d& point,
                                  const std::function<bool(std::uint32_t triangle)>& counts,
                                  Allowance& allowance);

/// Returns the volume within a closed surface, computed in double precision; negative if the
/// surface is inside out.
double signed_volume(const body::TriangleMesh& mesh);

/// A component whose volume would be counted wrongly in the sum over all components.
struct Misplaced {
  Eigen::Vector3d point;  ///< One of its vertices.
  bool is_within;         ///< Whether it lies within other components.
};

/// Returns the first component that is neither an outer surface, nor a cavity in one, nor an outer
/// surface within a cavity, and so on. If `is_inside_out`, all components are turned over.
/// Components must not intersect. Nothing if all are well placed or if the allowance is used up.
std::optional<Misplaced> misplaced_component(const TriangleTree& tree, const Topology& topology,
                                             bool is_inside_out, Allowance& allowance);

}  // namespace twrench::mesh
