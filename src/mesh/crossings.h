#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/allowance.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {

/// Two triangles that pass through each other.
struct Crossing {
  std::array<std::uint32_t, 2> triangles;
  Eigen::Vector3d point;  ///< One of the points that they share.
};

/// Pairs of triangles that pass through each other.
struct Crossings {
  std::size_t count = 0;
  /// Whether the search stopped early because far more triangles than usual are close to each
  /// other, such as those of a large fan. The result is then incomplete.
  bool is_incomplete = false;
  std::vector<Crossing> examples;  ///< Some of them; at least one if there are any.
};

/// Returns the pairs of triangles that pass through each other and do not merely touch. Triangles
/// with a common edge cannot cross. The search ends when the allowance is used up.
Crossings find_crossings(const TriangleTree& tree, Allowance& allowance);

}  // namespace twrench::mesh
