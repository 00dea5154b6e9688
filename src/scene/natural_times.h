#pragma once

#include <twrench/motion/free_body.h>

#include "scene/scene.h"

namespace twrench::scene {

/// The times that suit a motion, whatever its scale. At 1 rad/s they are the built-in values of the
/// T-wrench. All are round numbers and within their limits.
struct NaturalTimes {
  /// Integration step in s: the time of a turn by 0.01 rad.
  double step;
  /// Samples per second of motion: 60 per radian.
  double sample_rate;
  /// Duration of the motion in s: three flips, at most 1000 turns. For a body that does not turn
  /// over, three periods of the nutation, from 16 to 100 turns.
  double duration;
  /// Seconds of motion per second of video: a turn, unless the video would then last less than 10 s
  /// or more than 60 s.
  double speed;
};

/// Returns the times that suit the motion of a body; for a body at rest, those of 1 rad/s.
NaturalTimes natural_times(const motion::FreeBody& body);

/// Returns the times that suit the motion of a scene. Throws InvalidArgument as FreeBody does.
NaturalTimes natural_times(const Scene& scene);

}  // namespace twrench::scene
