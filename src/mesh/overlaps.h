#pragma once

#include <cstddef>

#include "mesh/allowance.h"
#include "mesh/triangle_tree.h"

namespace twrench::mesh {

/// Where a surface passes through itself.
struct Overlap {
  std::size_t crossings = 0;                        ///< Pairs of triangles that cross.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< Where one of them does.
  bool given_up = false;  ///< Whether they are not known, as the search would take too long.
  /// Whether there is a volume that the surface winds around twice or more, or the wrong way, which
  /// is more than a millionth of all.
  bool is_real = false;
  /// Whether that is not known, as the samples would take too long.
  bool is_unclear = false;
};

/// Finds where a closed surface passes through itself, and estimates by samples what volume that
/// concerns, with work that is taken from the allowance.
Overlap find_overlap(const TriangleTree& tree, bool is_inside_out, Allowance& allowance);

}  // namespace twrench::mesh
