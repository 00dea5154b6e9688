#include "check/verdict/free_flight.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstddef>
#include <vector>

namespace twrench::check {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using recording::Row;

/// The variance of the noise of each rate, from third differences, which a smooth motion hardly
/// has.
Vector3d variances_from_row_to_row(std::span<const Row> rows) {
  constexpr double of_difference = 1 + 9 + 9 + 1;
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 3; i < rows.size(); ++i) {
    const Vector3d difference =
        rows[i].omega - 3 * rows[i - 1].omega + 3 * rows[i - 2].omega - rows[i - 3].omega;
    sum += difference.cwiseAbs2();
  }
  return sum / (of_difference * static_cast<double>(rows.size() - 3));
}

/// The change of w x (I w) with each moment.
Matrix3d torques(const Vector3d& omega) {
  Matrix3d columns;
  for (int k = 0; k < 3; ++k) columns.col(k) = omega.cross(omega[k] * Vector3d::Unit(k));
  return columns;
}

/// Sums over rows of the matrix A, where A times the moments is constant in a free motion.
class FlightSums {
 public:
  explicit FlightSums(std::span<const Row> rows) {
    Matrix3d integral = Matrix3d::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i > 0) {
        integral += 0.5 * (rows[i].t - rows[i - 1].t) *
                    (torques(rows[i - 1].omega) + torques(rows[i].omega));
      }
      const Matrix3d A = integral + Matrix3d(rows[i].omega.asDiagonal());
      sums_.push_back(sums_.back() + A);
      squares_.push_back(squares_.back() + A.transpose() * A);
    }
  }

  /// The squares of the changes of A times the moments, as a quadratic form of the moments.
  Matrix3d squares(std::size_t begin, std::size_t end) const {
    const Matrix3d sum = sums_[end] - sums_[begin];
    return squares_[end] - squares_[begin] -
           sum.transpose() * sum / static_cast<double>(end - begin);
  }

 private:
  std::vector<Matrix3d> sums_{Matrix3d::Zero()}, squares_{Matrix3d::Zero()};
};

/// Whether a body can have these moments, up to their sign and an error of the estimate.
bool are_possible(const Vector3d& moments) {
  constexpr double least = 0.02, tolerance = 1.1;
  const Vector3d positive = moments.sum() < 0 ? Vector3d(-moments) : moments;
  const double largest = positive.maxCoeff();
  return positive.minCoeff() > least * largest && largest < tolerance * (positive.sum() - largest);
}

/// Whether the squares of `count` rows with noise of these standard deviations may be those of a
/// free motion.
bool may_be_free(const Matrix3d& squares, std::size_t count, const Vector3d& deviations) {
  const Matrix3d scale = deviations.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scale * squares * scale);
  const auto rows = static_cast<double>(count);
  const double sure = 4 * std::sqrt(2 / (3 * rows));  // of a mean of squares
  return solver.eigenvalues()[0] < (1 + sure) * rows &&
         are_possible(scale * solver.eigenvectors().col(0));
}

}  // namespace

std::optional<recording::Extract> free_flight(std::span<const Row> rows) {
  constexpr std::size_t least_rows = 40, steps = 60;
  if (rows.size() < least_rows) return std::nullopt;
  const Vector3d deviations = variances_from_row_to_row(rows).cwiseSqrt();
  if (!(deviations.minCoeff() > 0)) return std::nullopt;
  const FlightSums sums(rows);
  std::size_t begin = 0, end = 0;
  const auto at = [&](std::size_t step) { return step * rows.size() / steps; };
  for (std::size_t first = 0; first < steps; ++first) {
    for (std::size_t last = steps; last > first; --last) {
      const std::size_t count = at(last) - at(first);
      if (count < least_rows || count <= end - begin) break;
      if (!may_be_free(sums.squares(at(first), at(last)), count, deviations)) continue;
      begin = at(first), end = at(last);
    }
  }
  if (end == begin || end - begin == rows.size()) return std::nullopt;
  return recording::Extract{rows[begin].t, rows[end - 1].t};
}

}  // namespace twrench::check
