#pragma once

#include <twrench/motion/propagator.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace twrench::motion {

/// A sampled motion and its cost.
struct Trajectory {
  /// Samples in the order of the requested times.
  std::vector<Sample> samples;
  /// Number of steps, including rejected ones.
  std::int64_t steps = 0;
  /// Evaluations of omega, including those for samples between steps.
  std::int64_t evaluations = 0;
};

/// Returns the motion, sampled at exactly `times` (in s, in any order, of either sign).
///
/// The accepted steps t_k depend only on the method and the step control. A sample between t_k and
/// t_(k+1) is one shortened step from t_k that does not affect later steps. The sample at t
/// therefore has the same bits whichever other times are requested.
///
/// Throws OutOfRange about a "time" that is not finite and as make_propagator does; MotionError
/// when an adaptive step underflows, the motion diverges, a step is longer than a turn of the body
/// or otherwise too long for the method, or max_steps is exceeded.
Trajectory integrate(const FreeBody& body, const Method& method, const StepControl& control,
                     std::span<const double> times);

/// Calls `visit` with the samples at time(0), ..., time(count - 1), which must be ascending and not
/// negative. The samples are those of integrate(), but are not stored. Throws as integrate() does;
/// InvalidArgument about a "time" that is less than the previous one, and about "time" or "visit"
/// if the function is empty.
void visit_samples(const FreeBody& body, const Method& method, const StepControl& control,
                   std::size_t count, const std::function<double(std::size_t)>& time,
                   const std::function<void(const Sample&)>& visit);

/// Calls `visit` for each step that the method accepts, from t = 0 to the first that ends at t_end
/// (s, >= 0) or later. The closed form, which has no steps, advances by `control.step`. Throws as
/// integrate() does; OutOfRange about "t_end" if it is negative or not finite, and InvalidArgument
/// about "visit" if the function is empty.
void visit_steps(const FreeBody& body, const Method& method, const StepControl& control,
                 double t_end, const std::function<void(const AcceptedStep&)>& visit);

}  // namespace twrench::motion
