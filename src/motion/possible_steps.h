#pragma once

#include <twrench/motion/propagator.h>

namespace twrench::motion {

/// Throws MotionError if the steps to t_end, s, exceed the limit, before the first step is taken.
/// The limit also applies to the steps of the closed form.
void require_possible(const FreeBody& body, const Method& method, const StepControl& control,
                      double t_end);

}  // namespace twrench::motion
