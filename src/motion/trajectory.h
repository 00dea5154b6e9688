#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "motion/free_body.h"
#include "motion/method.h"

namespace twrench {

/// The smallest meaningful tolerance: the error estimate E of a step is a difference of two
/// rotations, each known to a few 1e-16.
inline constexpr double least_tolerance = 1e-15;

/// How an integration chooses its step sizes.
struct StepControl {
  /// Step size in s of a fixed-step method; initial step size of an adaptive one, limited to 0.9 of
  /// a revolution of the body.
  double step = 0.01;
  /// Error tolerance of adaptive methods: the bound on the estimate E of each step.
  double tolerance = 1e-10;
  /// Maximum number of steps of a trajectory, so that a mistake ends with an error instead of
  /// hanging.
  std::int64_t max_steps = 50'000'000;
};

/// A sampled motion and its cost.
struct Trajectory {
  /// Samples in the order of the requested times.
  std::vector<Sample> samples;
  /// Number of steps, including rejected ones.
  std::int64_t steps = 0;
  /// Evaluations of omega, including those for samples between steps.
  std::int64_t evaluations = 0;
};

/// Returns the motion from X(0) = Id, sampled at exactly `times` (in s, in any order, of either
/// sign).
///
/// The accepted steps t_k depend only on the method and the step control. A sample between t_k and
/// t_(k+1) is one shortened step from t_k that does not affect later steps, so that the sample at t
/// is bit-identical whichever other times are requested.
///
/// Throws UsageError if the tolerance is below least_tolerance, an adaptive step underflows, the
/// motion diverges, a step is longer than one revolution of the body or otherwise too long for the
/// method, or max_steps is exceeded.
Trajectory trajectory(const FreeBody& body, const Method& method, const StepControl& control,
                      std::span<const double> times);

/// Calls `visit` with the samples at time(0), ..., time(count - 1), which must be ascending and not
/// negative. The samples are those of trajectory(), but none is stored. Throws as trajectory()
/// does.
void visit_samples(const FreeBody& body, const Method& method, const StepControl& control,
                   std::size_t count, const std::function<double(std::size_t)>& time,
                   const std::function<void(const Sample&)>& visit);

/// An accepted step of a method.
struct OwnStep {
  double t;                       ///< Time at its start in s.
  double length;                  ///< Step size in s.
  Eigen::Matrix3d before, after;  ///< X at both ends.
  double error;                   ///< Error estimate E of an adaptive method; otherwise 0.
};

/// Calls `visit` for each accepted step from t = 0 to the first that ends at or after t_end (in s,
/// positive). The closed form, which has no steps of its own, uses steps of `control.step`. Throws
/// UsageError as trajectory() does.
void visit_steps(const FreeBody& body, const Method& method, const StepControl& control,
                 double t_end, const std::function<void(const OwnStep&)>& visit);

}  // namespace twrench
