#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "check/verdict/error_history.h"
#include "check/verdict/exact_rows.h"
#include "check/verdict/flips.h"
#include "check/verdict/noise.h"
#include "check/verdict/problem.h"
#include "recording/rows.h"

namespace twrench::check {

/// The errors of a quantity over all rows.
struct ErrorSize {
  double max = 0;  ///< largest component of a rate error, rad/s, or angle of an attitude error, rad
  double at = 0;   ///< time of the largest, s
  double rms = 0;  ///< root mean square of the same
};

/// The part of the attitude errors that is a steady rotation of the space frame itself: about one
/// axis of space and in proportion to the time.
struct FrameTurn {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();  ///< rad/s, axes of the file's space
  double share = 0;  ///< fraction of the squared attitude errors that it explains, 0 to 1
};

/// Compares rows with the exact motion, block by block, in memory that does not grow.
class Comparison {
 public:
  /// `reference` must outlive the comparison.
  Comparison(const Reference& reference, bool has_rates, bool has_attitude);

  /// Takes the next rows in order of time.
  void add(std::span<const recording::Row> rows);

  std::size_t rows() const { return rows_; }
  double last_time() const { return last_time_; }

  // Results over all rows so far; there must be at least one.
  ErrorSize rates() const { return size_of(rates_, 3); }
  double first_rate_error() const { return first_rate_error_; }
  ErrorSize attitude() const { return size_of(attitude_, 1); }
  /// Largest |drift| relative to the first row. If there are no rates, they are computed from the
  /// attitude and the exact L.
  double energy_drift() const { return energy_drift_; }
  double momentum_drift() const { return momentum_drift_; }
  /// Largest angle between L in space and that of the first row, rad.
  double direction_drift() const { return direction_drift_; }
  /// Largest |difference| relative to the exact motion.
  double energy_error() const { return energy_error_; }
  double momentum_error() const { return momentum_error_; }
  double orthogonality_error() const { return orthogonality_error_; }
  /// Largest magnitude of a component of the rates, rad/s, and of their derivative, rad/s^2.
  double largest_rate() const { return largest_rate_; }
  double largest_acceleration() const { return largest_acceleration_; }
  /// Upper bound of the angle to which the errors of the rates add up, rad.
  double accumulated_rate_error() const { return accumulated_; }
  FrameTurn frame_turn() const;
  std::vector<Span>& spans() { return course_.spans(); }
  FlipFinder& flips() { return flips_; }

 private:
  struct Sums {
    double max = 0, at = 0, squares = 0;
  };
  void add_to(Sums& sums, double error, double squares, double t) const;
  ErrorSize size_of(const Sums& sums, double components) const;

  void add_row(const recording::Row& row, const motion::Sample& exact);
  double compare_rates(const recording::Row& row, const motion::Sample& exact, Span& span);
  void compare_attitude(const recording::Row& row, const motion::Sample& exact, Span& span);
  void compare_invariants(const recording::Row& row, const Eigen::Vector3d& exact_omega);

  const Reference& reference_;
  motion::ExactMotion exact_;
  bool has_rates_, has_attitude_;
  ExactRows block_;
  Eigen::Vector3d L_;  ///< in the file's space

  std::size_t rows_ = 0;
  recording::Row first_;
  double last_time_ = 0, last_rate_error_ = 0, first_rate_error_ = 0;
  Sums rates_, attitude_;
  double first_energy_ = 0, energy_drift_ = 0, energy_error_ = 0;
  double momentum_drift_ = 0, momentum_error_ = 0, direction_drift_ = 0, orthogonality_error_ = 0;
  double largest_rate_ = 0, largest_acceleration_ = 0, accumulated_ = 0;
  double times_squared_ = 0, errors_squared_ = 0;
  Eigen::Vector3d last_attitude_error_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d times_errors_ = Eigen::Vector3d::Zero();
  DifferenceTable rate_table_, attitude_table_;
  ErrorHistory course_;
  FlipFinder flips_;
};

}  // namespace twrench::check
