#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mesh/allowance.h"
#include "mesh/topology.h"
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
