#include "mesh/polygon.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "mesh/allowance.h"

namespace twrench::mesh {
namespace {

/// Points in the plane, sorted into square cells with about one point each.
class PointGrid {
 public:
  /// The grid contains the points whose indices are `chosen`.
  PointGrid(std::span<const Eigen::Vector2d> points, std::span<const std::uint32_t> chosen);

  /// Removes the point with that index and place, if the grid contains it.
  void remove(std::uint32_t index, const Eigen::Vector2d& place);

  /// Searches the cells that intersect a triangle and returns the first point for which
  /// `is_wanted(index)` is true.
  template <typename Predicate>
  std::optional<std::uint32_t> find_near(const std::array<Eigen::Vector2d, 3>& triangle,
                                         const Predicate& is_wanted) const {
    const Eigen::AlignedBox2d box = bounds(triangle);
    for (std::size_t row = along(box.min(), 1); row <= along(box.max(), 1); ++row) {
      const auto [first, last] = columns_within(triangle, row);
      for (std::size_t cell = row * columns_ + first; cell <= row * columns_ + last; ++cell) {
        for (std::size_t i = begins_[cell]; i < ends_[cell]; ++i) {
          if (is_wanted(points_[i])) return points_[i];
        }
      }
    }
    return {};
  }

 private:
  static Eigen::AlignedBox2d bounds(const std::array<Eigen::Vector2d, 3>& triangle);
  /// Returns the column or row of a place; for a place outside the grid, the nearest one.
  std::size_t along(const Eigen::Vector2d& place, Eigen::Index axis) const;
  std::size_t cell(const Eigen::Vector2d& place) const {
    return along(place, 1) * columns_ + along(place, 0);
  }
  /// Returns the first and the last column in which the triangle intersects a row.
  std::array<std::size_t, 2> columns_within(const std::array<Eigen::Vector2d, 3>& triangle,
                                            std::size_t row) const;

  Eigen::AlignedBox2d box_;
  double size_ = 1;  ///< Edge length of a cell.
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::size_t> begins_, ends_;  ///< Ranges in `points_` of the cells, row by row.
  std::vector<std::uint32_t> points_;
};

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

PointGrid::PointGrid(std::span<const Vector2d> points, std::span<const std::uint32_t> chosen) {
  for (const std::uint32_t index : chosen) box_.extend(points[index]);
  if (chosen.empty()) box_.extend(Vector2d::Zero().eval());
  const auto count = static_cast<double>(chosen.size());
  const Vector2d sizes = box_.sizes();
  // The points may lie along a line. Computed from the area itself, which may underflow, the cells
  // would then be far too many.
  size_ = std::max({std::sqrt(sizes.x()) * std::sqrt(sizes.y() / std::max(count, 1.0)),
                    sizes.maxCoeff() / (count + 1), std::numeric_limits<double>::min()});
  columns_ = static_cast<std::size_t>(sizes.x() / size_) + 1;
  rows_ = static_cast<std::size_t>(sizes.y() / size_) + 1;
  begins_.resize(rows_ * columns_ + 1);
  for (const std::uint32_t index : chosen) ++begins_[cell(points[index]) + 1];
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
  ends_ = begins_;
  points_.resize(chosen.size());
  for (const std::uint32_t index : chosen) points_[ends_[cell(points[index])]++] = index;
}

void PointGrid::remove(std::uint32_t index, const Vector2d& place) {
  const std::size_t at = cell(place);
  const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(begins_[at]);
  const auto end = points_.begin() + static_cast<std::ptrdiff_t>(ends_[at]);
  const auto found = std::find(begin, end, index);
  if (found == end) return;
  std::iter_swap(found, end - 1);
  --ends_[at];
}

AlignedBox2d PointGrid::bounds(const std::array<Vector2d, 3>& triangle) {
  AlignedBox2d box;
  for (const Vector2d& corner : triangle) box.extend(corner);
  return box;
}

std::size_t PointGrid::along(const Vector2d& place, Eigen::Index axis) const {
  const double at = (place[axis] - box_.min()[axis]) / size_;
  const std::size_t last = (axis == 0 ? columns_ : rows_) - 1;
  return at > 0.0 ? std::min(static_cast<std::size_t>(std::min(at, 1e9)), last) : 0;
}

std::array<std::size_t, 2> PointGrid::columns_within(const std::array<Vector2d, 3>& triangle,
                                                     std::size_t row) const {
  // The band is slightly wider than the row, because corners are assigned to rows with rounding.
  constexpr double margin = 1e-6;
  const double low = box_.min().y() + (static_cast<double>(row) - margin) * size_;
  const double high = low + (1 + 2 * margin) * size_;
  AlignedBox2d within;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d &from = triangle[k], &to = triangle[(k + 1) % 3];
    for (const double y : {std::clamp(from.y(), low, high), std::clamp(to.y(), low, high)}) {
      const double share = from.y() == to.y() ? 0.0 : (y - from.y()) / (to.y() - from.y());
      if (share >= 0.0 && share <= 1.0) within.extend(Vector2d(from + share * (to - from)));
    }
    if (from.y() == to.y()) within.extend(to);
  }
  if (within.isEmpty()) return {0, columns_ - 1};
  return {along(within.min(), 0), along(within.max(), 0)};
}

/// The direction in which a path turns.
enum class Turn { left, straight, right };

using Eigen::Vector2d;
using Triangle = std::array<std::uint32_t, 3>;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Returns the direction in which the path from `a` via `b` to `c` turns; straight if the turn is
/// within round-off.
Turn turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d along = b - a, onward = c - a;
  const double area = along.x() * onward.y() - along.y() * onward.x();
  constexpr double round_off = 1e-12;
  const double touch = round_off * along.norm() * onward.norm();
  if (std::abs(area) <= touch) return Turn::straight;
  return area > 0.0 ? Turn::left : Turn::right;
}

/// Cuts off corners one by one. Each triangle cut off is counter-clockwise, so that in any order
/// the triangles together cover the polygon exactly once. Only corners at which the outline does
/// not turn left can block an ear.
class EarClipper {
 public:
  EarClipper(std::span<const Vector2d> polygon, Allowance& allowance)
      : points_(polygon),
        allowance_(&allowance),
        next_(polygon.size()),
        previous_(polygon.size()),
        waiting_(polygon.size()),
        left_(polygon.size()) {
    const auto count = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      next_[i] = (i + 1) % count;
      previous_[i] = (i + count - 1) % count;
    }
    queue_.resize(count);
    std::iota(queue_.begin(), queue_.end(), 0U);
    std::vector<std::uint32_t> hollows;
    std::ranges::copy_if(queue_, std::back_inserter(hollows),
                         [&](std::uint32_t i) { return turn_at(i) != Turn::left; });
    hollows_.emplace(polygon, hollows);
  }

  std::optional<std::vector<Triangle>> run() {
    for (std::size_t i = 0; left_ > 3; ++i) {
      if (i == queue_.size() || allowance_->is_used_up()) return {};
      if (!is_cut_off(queue_[i]) && is_ear(queue_[i])) cut_off(queue_[i]);
    }
    const auto last = static_cast<std::uint32_t>(
        std::ranges::find_if(next_, [](std::uint32_t n) { return n != none; }) - next_.begin());
    if (turn_at(last) == Turn::right) return {};
    triangles_.push_back(triangle_at(last));
    return std::move(triangles_);
  }

 private:
  bool is_cut_off(std::uint32_t i) const { return next_[i] == none; }
  Triangle triangle_at(std::uint32_t i) const { return {previous_[i], i, next_[i]}; }
  Turn turn_at(std::uint32_t i) const {
    return turn(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  /// Returns whether the triangle at a corner can be cut off. If another corner blocks it, the
  /// corner is queued until that one is cleared.
  bool is_ear(std::uint32_t i) {
    const Triangle ear = triangle_at(i);
    const std::array corners{points_[ear[0]], points_[ear[1]], points_[ear[2]]};
    const bool has_two_in_one_place =
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    if (has_two_in_one_place) return true;
    if (turn_at(i) != Turn::left) return false;
    std::size_t looks = 1;
    const auto blocker = hollows_->find_near(corners, [&](std::uint32_t other) {
      ++looks;
      return std::ranges::find(ear, other) == ear.end() && is_in_the_way(other, corners);
    });
    allowance_->take(3 * looks);
    if (blocker) waiting_[*blocker].push_back(i);
    return !blocker;
  }

  bool is_in_the_way(std::uint32_t other, const std::array<Vector2d, 3>& corners) const {
    const Vector2d& point = points_[other];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d &corner = corners[k], &from = corners[(k + 1) % 3], &to = corners[(k + 2) % 3];
      if (point == corner) {  // then the direction of the outline from there decides
        return std::ranges::any_of(std::array{previous_[other], next_[other]}, [&](auto neighbour) {
          return turn(corner, from, points_[neighbour]) == Turn::left &&
                 turn(corner, to, points_[neighbour]) == Turn::right;
        });
      }
      if (turn(corner, from, point) == Turn::right) return false;
    }
    return true;
  }

  void cut_off(std::uint32_t i) {
    triangles_.push_back(triangle_at(i));
    const std::uint32_t before = previous_[i], after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    next_[i] = none;
    --left_;
    for (const std::uint32_t neighbour : {before, after}) {
      queue_.push_back(neighbour);
      if (turn_at(neighbour) == Turn::left) clear_way(neighbour);
    }
    clear_way(i);
  }

  /// Marks a corner that no longer blocks others, and queues those that waited for it again.
  void clear_way(std::uint32_t blocker) {
    hollows_->remove(blocker, points_[blocker]);
    std::vector<std::uint32_t>& waiting = waiting_[blocker];
    queue_.insert(queue_.end(), waiting.begin(), waiting.end());
    waiting.clear();
  }

  std::span<const Vector2d> points_;
  Allowance* allowance_;
  std::vector<std::uint32_t> next_, previous_;       ///< Neighbours of the remaining corners.
  std::vector<std::vector<std::uint32_t>> waiting_;  ///< Corners that each corner blocks.
  std::size_t left_;
  std::vector<std::uint32_t> queue_;  ///< Corners to visit; some may have been cut off since.
  std::optional<PointGrid> hollows_;
  std::vector<Triangle> triangles_;
};

/// Splits a polygon in the plane, counter-clockwise, at its diagonals (G. H. Meisters, "Polygons
/// have ears", 1975). Corners may lie on an edge between others or coincide with them, so a hole
/// may be joined to the outline by an edge that is traversed both ways. Returns triangles as
/// indices of corners, two fewer than there are corners; they are counter-clockwise or without
/// area. Returns nothing if the polygon cannot be split, because it crosses itself, or if the
/// allowance is used up. The polygon must have at least three corners.
std::optional<std::vector<Triangle>> clip_ears(std::span<const Vector2d> polygon,
                                               Allowance& allowance) {
  return EarClipper(polygon, allowance).run();
}

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

std::vector<std::uint32_t> ring_of(std::span<const Triangle> fan) {
  std::vector<std::uint32_t> ring{fan[0][0], fan[0][1]};
  for (const Triangle& triangle : fan) ring.push_back(triangle[2]);
  return ring;
}

/// Returns the counter-clockwise projection of the polygon onto the coordinate plane in which it is
/// largest. It serves as well as the polygon's own plane and involves no rounding.
std::vector<Vector2d> projected(std::span<const std::uint32_t> ring,
                                const std::vector<Vector3d>& vertices) {
  std::vector<Vector3d> points;
  points.reserve(ring.size());
  for (const std::uint32_t corner : ring) points.emplace_back(vertices[corner] - vertices[ring[0]]);
  Vector3d normal = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < points.size(); ++i) normal += points[i].cross(points[i + 1]);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  Eigen::Index across = (axis + 1) % 3, up = (axis + 2) % 3;
  if (normal[axis] < 0.0) std::swap(across, up);
  std::vector<Vector2d> polygon;
  polygon.reserve(points.size());
  for (const Vector3d& point : points) polygon.emplace_back(point[across], point[up]);
  return polygon;
}

/// Returns whether no triangle of the fan is turned over or without area. The fan then covers the
/// polygon exactly once.
bool is_fan_inside(std::span<const Vector2d> polygon) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    if (turn(polygon[0], polygon[i], polygon[i + 1]) != Turn::left) return false;
  }
  return true;
}

}  // namespace

void Polygons::add(std::span<const std::uint32_t> ring, body::TriangleMesh& mesh) {
  if (ring.size() > 3) fans_.push_back({mesh.triangles.size(), ring.size() - 2});
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    mesh.triangles.push_back({ring[0], ring[k], ring[k + 1]});
  }
}

void Polygons::triangulate(body::TriangleMesh& mesh) const {
  Allowance allowance(usual_steps);
  for (const auto& [first, count] : fans_) {
    const std::span triangles(mesh.triangles.data() + first, count);
    const std::vector<std::uint32_t> ring = ring_of(triangles);
    const std::vector<Vector2d> polygon = projected(ring, mesh.vertices);
    // Differences of coordinates may overflow.
    const auto is_finite = [](const Vector2d& point) { return point.allFinite(); };
    if (!std::ranges::all_of(polygon, is_finite) || is_fan_inside(polygon)) continue;
    if (const auto ears = clip_ears(polygon, allowance)) {
      std::ranges::transform(*ears, triangles.begin(), [&](const Triangle& ear) {
        return Triangle{ring[ear[0]], ring[ear[1]], ring[ear[2]]};
      });
    }
  }
}

}  // namespace twrench::mesh
