#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace twrench::recording {

/// A row in the program's units and conventions.
struct Row {
  std::size_t number = 0;  ///< among the rows of data, from 1
  double t = 0;            ///< s since the first row
  /// rad/s, body axes; zero if the file has no rates.
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();
  /// space_from_body. Quaternions are normalised, matrices are not. The identity if the file has no
  /// attitude.
  Eigen::Matrix3d X = Eigen::Matrix3d::Identity();
  /// How far the file's numbers are from a rotation: Frobenius norm of X^T X - Id for a matrix,
  /// | |q|^2 - 1 | for a quaternion, 0 for Euler angles.
  double orthogonality_error = 0;
  /// Length of the Rodrigues parameters, tan(angle / 2); 0 for any other form.
  double rodrigues_length = 0;
};

/// The rows of a recording that count, by their times in s since its first row.
struct Extract {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  bool operator==(const Extract&) const = default;
};

/// The weights with which values at these times, one of which is 0, add up to their derivative at
/// 0, where the value is zero: those of the polynomial through them, by Lagrange's formula.
std::vector<double> derivative_weights(std::span<const double> times);

/// Evenly spread rows of a file of any length: the first and every 2^k-th after it.
class ThinnedRows {
 public:
  /// Keeps at most `most` rows; `most` must be even.
  explicit ThinnedRows(std::size_t most) : most_(most) {}

  void add(const Row& row);
  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::size_t most_;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
  std::vector<Row> rows_;
};

}  // namespace twrench::recording
