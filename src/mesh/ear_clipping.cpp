#include "mesh/ear_clipping.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "mesh/point_grid.h"

namespace twrench::mesh {
namespace {

using Eigen::Vector2d;
using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

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

}  // namespace

Turn turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const Vector2d along = b - a, onward = c - a;
  const double area = along.x() * onward.y() - along.y() * onward.x();
  constexpr double round_off = 1e-12;
  const double touch = round_off * along.norm() * onward.norm();
  if (std::abs(area) <= touch) return Turn::straight;
  return area > 0.0 ? Turn::left : Turn::right;
}

std::optional<std::vector<Triangle>> clip_ears(std::span<const Vector2d> polygon,
                                               Allowance& allowance) {
  return EarClipper(polygon, allowance).run();
}

}  // namespace twrench::mesh
