#pragma once

#include <optional>

#include "mesh/topology.h"

namespace twrench::mesh {

/// Returns the largest distance from an open edge to the open edge nearest to it that runs the
/// other way: the greater distance of their ends. Infinity where there is no other open edge.
double largest_gap(const body::TriangleMesh& mesh, const std::vector<DirectedEdge>& open);

/// Returns a tolerance at which welding closes the mesh and leaves it what it is, a round number
/// that is not much larger than the gap. All in units of `scale`. Nothing where there is none.
std::optional<double> closing_tolerance(const body::TriangleMesh& mesh, double gap, double scale);

}  // namespace twrench::mesh
