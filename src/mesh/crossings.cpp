#include "mesh/crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "mesh/allowance.h"

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

}  // namespace twrench::mesh
