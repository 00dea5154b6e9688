#pragma once

#include <optional>

#include "mesh/topology.h"

namespace twrench::mesh {

/// Returns the largest distance from an open edge to the nearest other open edge that runs the
/// opposite way. The distance of two edges is the greater distance of their ends. Infinity if there
/// is no other open edge.
double largest_gap(const body::TriangleMesh& mesh, const std::vector<DirectedEdge>& open);

/// Returns a tolerance at which welding closes the mesh without destroying it: a round number that
/// is not much larger than the gap. `mesh` and `gap` are in the mesh's unit, of `scale` cm; the
/// result is in cm. Nothing if there is no such tolerance.
std::optional<double> closing_tolerance(const body::TriangleMesh& mesh, double gap, double scale);

}  // namespace twrench::mesh
