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

/// Returns point n of a sequence that fills the box evenly (M. Roberts' R3 sequence).
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

/// Returns the intersection of two boxes, enlarged on each side by its greatest extent.
AlignedBox3d around(const AlignedBox3d& one, const AlignedBox3d& other) {
  const AlignedBox3d common = one.intersection(other);
  const Vector3d margin = Vector3d::Constant(common.sizes().maxCoeff());
  return {common.min() - margin, common.max() + margin};
}

/// Estimates from samples the volume within a box where the winding number is neither 0 nor 1.
/// Stops sampling when the allowance is used up.
double wrong_volume(const TriangleTree& tree, const AlignedBox3d& box, int samples, int turn,
                    Allowance& allowance) {
  int wrong = 0;
  for (int n = 0; n < samples && !allowance.is_used_up(); ++n) {
    const auto winding = winding_number(
        tree, sample_point(box, n), [](std::uint32_t) { return true; }, allowance);
    if (winding && (turn * *winding < 0 || turn * *winding > 1)) ++wrong;
  }
  return wrong * box.volume() / samples;
}

/// A triangle takes about 40 steps if only its neighbours are close to it. If more are close, the
/// search may take 10 s on one processor.
std::size_t steps_for_crossings(std::size_t triangles) {
  constexpr std::size_t ten_seconds = 1'000'000'000;
  return std::max(std::clamp(1000 * triangles, usual_steps, ten_seconds), 100 * triangles);
}

}  // namespace

Overlap find_overlap(const TriangleTree& tree, bool is_inside_out, Allowance& allowance) {
  Allowance for_crossings(steps_for_crossings(tree.mesh().triangles.size()));
  const Crossings crossings = find_crossings(tree, for_crossings);
  if (crossings.count == 0) return {.is_incomplete = crossings.is_incomplete};
  const int turn = is_inside_out ? -1 : 1;
  AlignedBox3d all;
  double near_crossings = 0.0;
  constexpr std::size_t most_boxes = 256;
  const std::size_t step = crossings.examples.size() / most_boxes + 1;
  for (std::size_t i = 0; i < crossings.examples.size(); ++i) {
    const auto& triangles = crossings.examples[i].triangles;
    const AlignedBox3d one = box_of(tree, triangles[0]), other = box_of(tree, triangles[1]);
    all.extend(one.merged(other));
    if (i % step != 0) continue;
    near_crossings += wrong_volume(tree, around(one, other), 32, turn, allowance);
  }
  // Both estimates are needed: small triangles may cross at the rim of a large overlap, and large
  // triangles may cross only in a corner.
  const double wrong = std::max(near_crossings, wrong_volume(tree, all, 2048, turn, allowance));
  const bool is_real = wrong > 1e-6 * std::abs(signed_volume(tree.mesh()));
  return {.crossings = crossings.count,
          .point = crossings.examples.front().point,
          .is_real = is_real,
          .is_unclear = !is_real && allowance.is_used_up()};
}

}  // namespace twrench::mesh
