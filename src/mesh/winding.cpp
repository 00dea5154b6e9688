#include "mesh/winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;

/// How a ray meets a triangle.
enum class Hit { nothing, from_inside, from_outside, unclear };

/// A half-line. No component of its direction is 0.
struct Ray {
  Vector3d origin, direction;

  /// Returns whether the ray intersects a box, which is in the same frame.
  bool meets(const Eigen::AlignedBox3d& box) const {
    double begin = 0.0, end = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < 3; ++i) {
      double near = (box.min()[i] - origin[i]) / direction[i];
      double far = (box.max()[i] - origin[i]) / direction[i];
      if (near > far) std::swap(near, far);
      begin = std::max(begin, near), end = std::min(end, far);
    }
    return begin <= end;
  }

  Hit hit(const std::array<Vector3d, 3>& corners) const {
    const Vector3d a = corners[0] - origin, b = corners[1] - origin, c = corners[2] - origin;
    const double size = std::max({a.norm(), b.norm(), c.norm()});
    // Unless the ray passes on the same side of all edges, it misses the triangle.
    const Vector3d sides(direction.dot(a.cross(b)), direction.dot(b.cross(c)),
                         direction.dot(c.cross(a)));
    const double round_off = 4e-15 * size * size;
    if (sides.maxCoeff() > round_off && sides.minCoeff() < -round_off) return Hit::nothing;
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double height = normal.dot(a), rate = normal.dot(direction);
    const bool is_ahead = (height > 0.0) == (rate > 0.0);
    const bool is_near = std::abs(height) <= 1e-12 * size * normal.norm();
    if (!is_ahead && !is_near) return Hit::nothing;
    if (is_near || sides.cwiseAbs().minCoeff() <= round_off) return Hit::unclear;
    return rate > 0.0 ? Hit::from_inside : Hit::from_outside;
  }
};

/// Returns the sum over all triangles that the ray hits; nothing if one of the hits is unclear.
std::optional<int> sum_along(const TriangleTree& tree, const Ray& ray,
                             const std::function<bool(std::uint32_t)>& counts,
                             Allowance& allowance) {
  const Ray in_tree{ray.origin - tree.whole().min(), ray.direction};
  const double round_off = 1e-6 * tree.whole().diagonal().norm();  // of single precision
  int sum = 0;
  std::vector<std::size_t> open{1};
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    allowance.take(tree.is_leaf(node) ? 10 : 2);
    if (tree.box(node).isEmpty()) continue;
    const Eigen::Vector3d margin = Vector3d::Constant(round_off);
    const Eigen::AlignedBox3d box(tree.box(node).min().cast<double>() - margin,
                                  tree.box(node).max().cast<double>() + margin);
    if (!in_tree.meets(box)) continue;
    if (!tree.is_leaf(node)) {
      open.push_back(2 * node);
      open.push_back(2 * node + 1);
      continue;
    }
    for (const auto& [_, triangle] : tree.items(node)) {
      if (!counts(triangle)) continue;
      const Hit hit =
          ray.hit({tree.corner(triangle, 0), tree.corner(triangle, 1), tree.corner(triangle, 2)});
      if (hit == Hit::unclear) return {};
      sum += hit == Hit::from_inside ? 1 : hit == Hit::from_outside ? -1 : 0;
    }
  }
  return sum;
}

}  // namespace

std::optional<int> winding_number(const TriangleTree& tree, const Vector3d& point,
                                  const std::function<bool(std::uint32_t)>& counts,
                                  Allowance& allowance) {
  // Directions along which models are unlikely to have edges. There are several because a ray may
  // still pass through an edge.
  static const std::array<Vector3d, 4> directions{{{0.8147, 0.1270, 0.5658},
                                                   {-0.3171, 0.9058, 0.2785},
                                                   {0.0975, -0.5469, 0.8314},
                                                   {-0.6324, -0.1576, -0.7584}}};
  for (const Vector3d& direction : directions) {
    if (const auto sum = sum_along(tree, {point, direction}, counts, allowance)) return sum;
  }
  return {};
}

}  // namespace twrench::mesh
