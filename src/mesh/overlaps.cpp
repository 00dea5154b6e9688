#include "mesh/overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector3d;
constexpr std::size_t most_examples = 16;  // of each task

/// A triangle's corners and its plane.
struct Plane {
  std::array<Vector3d, 3> corners;
  Vector3d normal;  ///< Its length is twice the area.

  Plane(const TriangleTree& tree, std::uint32_t triangle)
      : corners{tree.corner(triangle, 0), tree.corner(triangle, 1), tree.corner(triangle, 2)},
        normal((corners[1] - corners[0]).cross(corners[2] - corners[0])) {}

  /// Returns the signed distances of another triangle's corners from the plane, times the normal's
  /// length.
  Vector3d heights(const Plane& other) const {
    return {normal.dot(other.corners[0] - corners[0]), normal.dot(other.corners[1] - corners[0]),
            normal.dot(other.corners[2] - corners[0])};
  }

  /// Returns whether there are corners on both sides of the plane, farther away than a touch.
  bool is_between(const Vector3d& heights, double touch) const {
    const double least = heights.minCoeff(), greatest = heights.maxCoeff();
    if (least >= 0.0 || greatest <= 0.0) return false;
    return std::min(-least, greatest) > touch * normal.norm();
  }

  /// Returns whether a point of the plane is within the triangle or on its border.
  bool holds(const Vector3d& point) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d edge = corners[(k + 1) % 3] - corners[k], to_point = point - corners[k];
      const double round_off = 1e-12 * edge.norm() * (edge.norm() + to_point.norm());
      if (normal.dot(edge.cross(to_point)) < -round_off * normal.norm()) return false;
    }
    return true;
  }

  /// Returns the point where an edge of another triangle passes through this one. The edge must
  /// reach farther than a touch on both sides. Nothing if no edge does.
  std::optional<Vector3d> point_of_passage(const Plane& other, const Vector3d& heights,
                                           double touch) const {
    const double limit = touch * normal.norm();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double from = heights[static_cast<Eigen::Index>(k)],
                   to = heights[static_cast<Eigen::Index>(next)];
      if (std::min(from, to) >= -limit || std::max(from, to) <= limit) continue;
      const Vector3d edge = other.corners[next] - other.corners[k];
      const Vector3d point = other.corners[k] + from / (from - to) * edge;
      if (holds(point)) return point;
    }
    return {};
  }
};

/// Returns a common point of two triangles that pass through each other farther than a touch.
std::optional<Vector3d> crossing_of(const Plane& a, const Plane& b, double touch) {
  const Vector3d from_a = a.heights(b);
  if (!a.is_between(from_a, touch)) return {};
  const Vector3d from_b = b.heights(a);
  if (!b.is_between(from_b, touch)) return {};
  if (const auto point = a.point_of_passage(b, from_a, touch)) return point;
  return b.point_of_passage(a, from_b, touch);
}

/// Returns whether a box is flat and the other box lies on one side of it, so that their contents
/// cannot cross. This test matters at the ends of a cylinder, where many triangles are close to all
/// others.
bool is_beside(const Eigen::AlignedBox3f& flat, const Eigen::AlignedBox3f& other) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    const float place = flat.min()[i];
    if (flat.max()[i] == place && (other.min()[i] >= place || other.max()[i] <= place)) return true;
  }
  return false;
}

/// Finds the crossings between nodes of the tree.
class Search {
 public:
  Search(const TriangleTree& tree, double touch, Allowance& allowance)
      : tree_(&tree), touch_(touch), allowance_(&allowance) {}

  /// Searches between the triangles of two nodes on the same level, or within one node if `a`
  /// equals `b`.
  void run(std::size_t a, std::size_t b) {
    search(a, b);
    allowance_->take(steps_);
    steps_ = 0;
  }

  Crossings found;

 private:
  void search(std::size_t a, std::size_t b) {
    count(1);
    if (!tree_->box(a).intersects(tree_->box(b))) return;
    if (is_beside(tree_->box(a), tree_->box(b)) || is_beside(tree_->box(b), tree_->box(a))) return;
    if (allowance_->is_used_up()) return;
    if (tree_->is_leaf(a)) return compare_leaves(a, b);
    search(2 * a, 2 * b);
    search(2 * a, 2 * b + 1);
    if (a != b) search(2 * a + 1, 2 * b);
    search(2 * a + 1, 2 * b + 1);
  }

  void count(std::size_t steps) {
    constexpr std::size_t some = 16384;  // so that threads seldom wait for each other
    steps_ += steps;
    if (steps_ < some) return;
    allowance_->take(steps_);
    steps_ = 0;
  }

  void compare_leaves(std::size_t a, std::size_t b) {
    count(tree_->items(a).size() + tree_->items(b).size());
    for (const auto& [box, one] : tree_->items(a)) {
      if (!box.intersects(tree_->box(b))) continue;
      for (const auto& [other_box, other] : tree_->items(b)) {
        if (box.intersects(other_box) && (a != b || one < other)) compare(one, other);
      }
    }
  }

  void compare(std::uint32_t one, std::uint32_t other) {
    count(4);
    const auto& corners = tree_->mesh().triangles[one];
    const auto shared = std::ranges::count_if(tree_->mesh().triangles[other], [&](auto corner) {
      return std::ranges::find(corners, corner) != corners.end();
    });
    if (shared > 1) return;
    const auto point = crossing_of(Plane(*tree_, one), Plane(*tree_, other), touch_);
    if (!point) return;
    ++found.count;
    if (found.examples.size() < most_examples) found.examples.push_back({{one, other}, *point});
  }

  const TriangleTree* tree_;
  double touch_;
  Allowance* allowance_;
  std::size_t steps_ = 0;  ///< Not yet deducted from the allowance.
};

}  // namespace

Crossings find_crossings(const TriangleTree& tree, Allowance& allowance) {
  const double touch = 1e-9 * tree.whole().diagonal().norm();
  const std::size_t first = std::min<std::size_t>(tree.first_leaf(), 64);
  std::vector<std::pair<std::size_t, std::size_t>> tasks;
  for (std::size_t a = first; a < 2 * first; ++a) {
    for (std::size_t b = a; b < 2 * first; ++b) {
      if (tree.box(a).intersects(tree.box(b))) tasks.emplace_back(a, b);
    }
  }
  std::vector<Search> searches(tasks.size(), Search(tree, touch, allowance));
  for_each_part(tasks.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) searches[i].run(tasks[i].first, tasks[i].second);
  });
  Crossings all;
  if (allowance.is_used_up()) return {.is_incomplete = true, .examples = {}};
  for (const Search& search : searches) {
    all.count += search.found.count;
    all.examples.insert(all.examples.end(), search.found.examples.begin(),
                        search.found.examples.end());
  }
  return all;
}

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
