#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace twrench::mesh {

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

}  // namespace twrench::mesh
