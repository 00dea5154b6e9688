#pragma once

#include <cstddef>

#include "motion/scheme.h"

namespace twrench::motion {

/// Returns the order of the series. Throws OutOfRange unless it is even and 2 to max_taylor_order.
std::size_t checked_order(const Taylor& method);

/// The norms of the last two coefficients of a series, per unit of time. Two are needed, because
/// every other coefficient of a motion with a symmetry in time is zero.
struct LastTerms {
  std::size_t order;  ///< Order of the last term.
  double before;
  double last;

  /// Returns the larger contribution after the time s, of either sign.
  double after(double s) const;

  /// Returns the longest s > 0 for which after(s) is within `tolerance`. It is known before the
  /// step is taken, so that no step is rejected. Source: Jorba and Zou, Experimental Mathematics 14
  /// (2005).
  double longest_time(double tolerance) const;
};

}  // namespace twrench::motion
