#include "mesh/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace twrench::mesh {

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

}  // namespace twrench::mesh
