#pragma once

#include <twrench/motion/exact.h>

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "recording/rows.h"

namespace twrench::check {

/// The exact motion at many times. Reuses its memory from one block of rows to the next.
class ExactRows {
 public:
  /// Evaluates the motion at `times` in s.
  void evaluate(const motion::ExactMotion& exact, std::span<const double> times);
  /// Evaluates it at the times of the rows, counted from `start` in s.
  void evaluate(const motion::ExactMotion& exact, double start,
                std::span<const recording::Row> rows);

  Eigen::Vector3d omega(std::size_t i) const {
    return Eigen::Map<const Eigen::Vector3d>(&omega_[3 * i]);
  }
  Eigen::Matrix3d X(std::size_t i) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&X_[9 * i]);
  }

 private:
  std::vector<double> times_, X_, omega_;
};

}  // namespace twrench::check
