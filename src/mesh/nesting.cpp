#include "mesh/nesting.h"

#include <Eigen/Geometry>
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

namespace {

using body::TriangleMesh;
using Eigen::Vector3d;

double six_volumes(const TriangleMesh& mesh, std::size_t triangle, const Vector3d& from) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return (mesh.vertices[a] - from).dot((mesh.vertices[b] - from).cross(mesh.vertices[c] - from));
}

/// A connected component of the surface.
struct Component {
  std::vector<std::uint32_t> samples;  ///< Some of its triangles.
  double six_volumes = 0.0;            ///< Six times the signed volume.
  double size = 0.0;                   ///< The sum of the magnitudes of its terms.
};

std::vector<Component> components_of(const TriangleMesh& mesh, const Topology& topology) {
  constexpr std::size_t most_samples = 16;
  std::vector<Component> components(topology.components);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    Component& component = components[topology.component[i]];
    if (component.samples.size() < most_samples) component.samples.push_back(i);
    const Vector3d& from = mesh.vertices[mesh.triangles[component.samples.front()][0]];
    const double term = six_volumes(mesh, i, from);
    component.six_volumes += term;
    component.size += std::abs(term);
  }
  return components;
}

/// Returns how often the other components wind around a component. The number is the same
/// everywhere on it, because they do not intersect. Nothing if they coincide with it in all
/// samples.
std::optional<int> winding_of_others(const TriangleTree& tree, const Topology& topology,
                                     const Component& component, Allowance& allowance) {
  const std::uint32_t own = topology.component[component.samples.front()];
  const auto is_other = [&](std::uint32_t triangle) { return topology.component[triangle] != own; };
  for (const std::uint32_t sample : component.samples) {
    const Vector3d middle =
        (tree.corner(sample, 0) + tree.corner(sample, 1) + tree.corner(sample, 2)) / 3.0;
    if (allowance.is_used_up()) return {};
    if (const auto winding = winding_number(tree, middle, is_other, allowance)) return winding;
  }
  return {};
}

}  // namespace

double signed_volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  const Vector3d& from = mesh.vertices[mesh.triangles[0][0]];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sum += six_volumes(mesh, i, from);
  return sum / 6.0;
}

std::optional<Misplaced> misplaced_component(const TriangleTree& tree, const Topology& topology,
                                             bool is_inside_out, Allowance& allowance) {
  if (topology.components < 2) return {};
  const int turn = is_inside_out ? -1 : 1;
  for (const Component& component : components_of(tree.mesh(), topology)) {
    // A component that encloses nothing, such as a sheet with two sides, adds nothing.
    if (std::abs(component.six_volumes) <= 1e-12 * component.size) continue;
    const std::optional<int> around = winding_of_others(tree, topology, component, allowance);
    if (!around) continue;
    const int outside = turn * *around, own = component.six_volumes > 0.0 ? turn : -turn;
    // The surface must wind once around one side of the component and not at all around the other.
    if (outside == (own > 0 ? 0 : 1)) continue;
    return Misplaced{tree.corner(component.samples.front(), 0), outside != 0};
  }
  return {};
}

}  // namespace twrench::mesh
