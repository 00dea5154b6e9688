#include "mesh/overlaps.h"

#include <algorithm>
#include <cmath>

#include "mesh/crossings.h"
#include "mesh/nesting.h"
#include "mesh/winding.h"

namespace twrench::mesh {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// The n-th of points that fill the box evenly (M. Roberts' R3 sequence).
Vector3d sample_point(const AlignedBox3d& box, int n) {
  const Vector3d steps(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
  const Vector3d part = (Vector3d::Constant(0.5) + (n + 1) * steps).unaryExpr([](double x) {
    return x - std::floor(x);
  });
  return box.min() + part.cwiseProduct(box.sizes());
}

AlignedBox3d box_of(const TriangleTree& tree, std::uint32_t triangle) {
  AlignedBox3d box;
  for (std::size_t k = 0; k < 3; ++k) box.extend(tree.corner(triangle, k));
  return box;
}

/// What two boxes have in common, and as much again around it.
AlignedBox3d around(const AlignedBox3d& one, const AlignedBox3d& other) {
  const AlignedBox3d common = one.intersection(other);
  const Vector3d margin = Vector3d::Constant(common.sizes().maxCoeff());
  return {common.min() - margin, common.max() + margin};
}

/// The volume within a box that does not count once or not at all, estimated from some samples.
double wrong_volume(const TriangleTree& tree, const AlignedBox3d& box, int samples, int turn) {
  int wrong = 0;
  for (int n = 0; n < samples; ++n) {
    const auto winding =
        winding_number(tree, sample_point(box, n), [](std::uint32_t) { return true; });
    if (winding && (turn * *winding < 0 || turn * *winding > 1)) ++wrong;
  }
  return wrong * box.volume() / samples;
}

}  // namespace

Overlap find_overlap(const TriangleTree& tree, bool is_inside_out) {
  const Crossings crossings = find_crossings(tree);
  if (crossings.count == 0) return {.given_up = crossings.given_up};
  const int turn = is_inside_out ? -1 : 1;
  AlignedBox3d all;
  double near_crossings = 0.0;
  constexpr std::size_t most_boxes = 256;
  const std::size_t step = crossings.examples.size() / most_boxes + 1;
  for (std::size_t i = 0; i < crossings.examples.size(); ++i) {
    const auto& triangles = crossings.examples[i].triangles;
    const AlignedBox3d one = box_of(tree, triangles[0]), other = box_of(tree, triangles[1]);
    all.extend(one.merged(other));
    if (i % step == 0) near_crossings += wrong_volume(tree, around(one, other), 32, turn);
  }
  // Small triangles may cross at the rim of a large overlap, large ones in a corner of theirs.
  const double wrong = std::max(near_crossings, wrong_volume(tree, all, 2048, turn));
  return {.crossings = crossings.count,
          .point = crossings.examples.front().point,
          .is_real = wrong > 1e-6 * std::abs(signed_volume(tree.mesh()))};
}

}  // namespace twrench::mesh
