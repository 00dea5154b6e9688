#pragma once

#include <cstddef>

#include "mesh/allowance.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {

/// The self-intersection of a surface.
struct Overlap {
  std::size_t crossings = 0;                        ///< Pairs of triangles that cross.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< A point of one of the crossings.
  bool is_incomplete = false;  ///< Whether the search was abandoned because it would take too long.
  /// Whether the surface winds twice or more, or the wrong way, around more than a millionth of the
  /// whole volume.
  bool is_real = false;
  /// Whether `is_real` is undetermined because the samples would take too long.
  bool is_unclear = false;
};

/// Finds where a closed surface passes through itself and estimates the affected volume from
/// samples. Deducts the work from the allowance.
Overlap find_overlap(const TriangleTree& tree, bool is_inside_out, Allowance& allowance);

}  // namespace twrench::mesh
