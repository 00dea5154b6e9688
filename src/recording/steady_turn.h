#pragma once

#include "recording/rows.h"

namespace twrench::recording {

/// Detects rates that are exact however few digits they have, because they never change and the
/// attitude turns at them.
class SteadyTurn {
 public:
  void add(const Row& row);

  /// Whether the attitude, known up to `angle` in rad, shows that the rates are right to a small
  /// part of their last digit `rate` in rad/s.
  bool determines_rates(double rate, double angle) const;

  /// The rates of all rows, rad/s; meaningful if they never change.
  const Eigen::Vector3d& omega() const { return first_.omega; }

 private:
  Row first_;
  bool is_steady_ = true;
  double duration_ = 0;  ///< s
  double farthest_ = 0;  ///< the largest angle between the attitude and a steady turn, rad
};

}  // namespace twrench::recording
