#pragma once

#include <optional>

#include "mesh/allowance.h"
#include "mesh/topology.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {

/// The volume within a closed surface, negative where it is inside out, to double precision.
double signed_volume(const body::TriangleMesh& mesh);

/// A component of a surface that would count wrongly in a sum over all.
struct Misplaced {
  Eigen::Vector3d point;  ///< One of its vertices.
  bool is_within;         ///< Whether it lies within others, rather than among them.
};

/// Returns the first component that is neither an outer surface nor a cavity in one, nor an outer
/// surface within a cavity and so on; `is_inside_out` tells that all are turned over. No two may
/// intersect. Nothing where all are well, or where the allowance is used up.
std::optional<Misplaced> misplaced_component(const TriangleTree& tree, const Topology& topology,
                                             bool is_inside_out, Allowance& allowance);

}  // namespace twrench::mesh
