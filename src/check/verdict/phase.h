#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "check/verdict/error_history.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// The errors, divided into phase and amplitude. The phase is the position of a motion along its
/// polhode; the amplitude is which polhode it is on and where L points. A motion with only its
/// phase wrong is the exact motion at another time, turned about L.
struct ErrorParts {
  double delay = 0;           ///< s by which the file is late on its polhode, of largest magnitude
  double delay_at = 0;        ///< time of `delay`, s
  double delay_at_end = 0;    ///< at the last row, s
  double phase_rate = 0;      ///< largest rate error that the delay explains, rad/s
  double angle_about_l = 0;   ///< largest |angle| about L beyond what the delay explains, rad
  double amplitude_rate = 0;  ///< largest rate error that the delay does not explain, rad/s
  double tilt = 0;            ///< largest attitude error across L that it does not explain, rad
};

/// Divides the errors at the last rows of the spans. These need rates (body axes, rad/s); for a
/// file without, those that follow from the attitude. Returns nothing for a steady motion, which
/// has no phase.
std::optional<ErrorParts> error_parts(const Reference& reference, std::span<const Span> spans,
                                      bool has_attitude);

}  // namespace twrench::check
