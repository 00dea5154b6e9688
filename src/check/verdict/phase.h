#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "check/verdict/course.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// How errors divide. Where a motion is on its way along the polhode is its phase; which polhode it
/// is on, and which way L points, is its amplitude. What has the phase wrong alone is the exact
/// motion at another time, turned about L.
struct ErrorParts {
  double delay = 0;           ///< s by which the file is late on its polhode, where |it| is largest
  double delay_at = 0;        ///< when, s
  double delay_at_end = 0;    ///< at the last row, s
  double phase_rate = 0;      ///< largest rate error that the delay explains, rad/s
  double angle_about_l = 0;   ///< largest |angle| about L beyond what the delay explains, rad
  double amplitude_rate = 0;  ///< largest rate error that is left without the delay, rad/s
  double tilt = 0;            ///< largest attitude error across L that is left without it, rad
};

/// Divides the errors at the last rows of spans, given the rates of each (body axes, rad/s; those
/// that the attitude implies where a file has no others). Nothing for a steady motion, which has no
/// phase.
std::optional<ErrorParts> error_parts(const Reference& reference, std::span<const Span> spans,
                                      bool has_attitude);

}  // namespace twrench::check
