#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "motion/propagator.h"

namespace twrench {

/// A motion, and what it cost.
struct Trajectory {
  std::vector<Sample> samples;   ///< in the order of the times that were asked for
  std::int64_t steps = 0;        ///< rejected ones too
  std::int64_t evaluations = 0;  ///< of omega, those for samples between steps included
};

/// The motion from X(0) = Id, sampled at exactly `times` (s, any order, negative ones too).
///
/// The method's own steps t_k depend on the method and the control alone. A sample between t_k and
/// t_(k+1) is one shortened step from t_k, which the steps after it do not see: so a sample at t is
/// the same number whichever other times were asked for.
///
/// Throws OutOfRange for a time that is not finite and as make_propagator does; MotionError when an
/// adaptive step underflows, the motion diverges, a step is longer than a turn of the body or
/// otherwise too long for the method, or max_steps is passed.
Trajectory trajectory(const FreeBody& body, const Method& method, const StepControl& control,
                      std::span<const double> times);

/// Calls `visit` for the motion at time(0), ..., time(count - 1) in turn, which must ascend from 0
/// or above: the samples that trajectory has, none of which is kept. Throws as trajectory.
void visit_samples(const FreeBody& body, const Method& method, const StepControl& control,
                   std::size_t count, const std::function<double(std::size_t)>& time,
                   const std::function<void(const Sample&)>& visit);

/// Calls `visit` for each of the method's own steps, those it accepts, from t = 0 to the first that
/// ends at t_end (s, > 0) or beyond. The closed form, which has none, goes in steps of
/// `control.step`. Throws as trajectory.
void visit_steps(const FreeBody& body, const Method& method, const StepControl& control,
                 double t_end, const std::function<void(const OwnStep&)>& visit);

}  // namespace twrench
