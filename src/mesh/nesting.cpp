#include "mesh/nesting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/winding.h"

namespace twrench::mesh {
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
