#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <array>
#include <limits>

#include "motion/scheme.h"
#include "motion/series_steps.h"

namespace twrench::motion {

/// The motion of a body with a wheel or energy loss as a Taylor series in time. With m = X^T L,
///  w = I^-1 (m - h),  c = m x w,  omega = w + a c,  m' = m x omega,  q' = q omega / 2,
/// where q is the quaternion of the rotation since the expansion point. TaylorSeries has the same
/// functions; it is faster, but only for rigid bodies.
class InteriorSeries {
 public:
  /// The attitude, which determines m.
  struct State {
    Eigen::Matrix3d X;  ///< space_from_body.
  };

  /// Throws OutOfRange unless the order is even and 2 to max_taylor_order.
  InteriorSeries(const FreeBody& body, const Taylor& method);

  /// Returns the state of an attitude space_from_body. The momentum is not used, because it follows
  /// from the attitude.
  State state_of(const Eigen::Matrix3d& X, const Eigen::Vector3d& momentum) const;
  /// Returns the sample of a state at the time t in s.
  Sample sample(double t, const State& state) const;
  /// Moves the expansion point. The last terms that contribute less than round-off within `longest`
  /// s are left out.
  void expand(const State& state, double longest = std::numeric_limits<double>::infinity());
  /// The number of series that are expanded together.
  static constexpr std::size_t lanes = 8;
  /// Expands series of one body from their states, at a fraction of the cost and with the same bits
  /// as expand().
  static void expand_together(std::array<InteriorSeries, lanes>& series,
                              const std::array<State, lanes>& states,
                              const std::array<double, lanes>& longest);
  /// Returns the state h seconds after the expansion point.
  State at(double h) const;
  /// Returns the larger of the contributions of the last two orders to X after h seconds, in the
  /// Frobenius norm.
  double last_terms(double h) const { return last().after(h / time_unit_); }
  /// Returns the longest h > 0 in s for which last_terms(h) is within `tolerance`.
  double max_step(double tolerance) const { return time_unit_ * last().longest_time(tolerance); }

 private:
  /// A contribution to the quaternion that is negligible beside 1.
  static constexpr double negligible = 1e-19;

  struct Together;
  struct Quaternion {
    double w;
    Eigen::Vector3d v;
  };

  LastTerms last() const;

  FreeBody body_;
  std::size_t order_;
  double momentum_unit_ = 1;  ///< g cm^2/s
  double time_unit_ = 1;      ///< s; |omega| is at most 1 in the inverse of this unit.
  double loss_ = 0;           ///< a in these units.
  Eigen::Matrix3d inverse_;   ///< I^-1 in these units.
  State start_;
  std::array<Quaternion, max_taylor_order + 1> q_;  ///< Coefficients.
  std::size_t last_order_ = 0;                      ///< The order of the last term kept.
};

}  // namespace twrench::motion
