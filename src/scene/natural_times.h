#pragma once

#include <twrench/motion/free_body.h>

#include "scene/scene.h"

namespace twrench::scene {

/// The times that suit a motion, whatever its scale. At 1 rad/s they are the built-in values of the
/// T-wrench. All are rounded to one digit or two, and within their limits.
struct NaturalTimes {
  /// Integration step in s: the time of a turn by 0.01 rad.
  double step;
  /// Samples per second of motion: 60 per radian.
  double sample_rate;
  /// Duration of the motion in s: three flips, at most 1000 turns. For a body that does not turn
  /// over, three periods of the nutation, from 16 to 100 turns. With energy loss five of its time
  /// constants, from 16 to 1000 turns; with a wheel alone 16 turns.
  double duration;
  /// Seconds of motion per second of video: a turn, unless the video would then last less than 10 s
  /// or more than 60 s.
  double speed;
};

/// Returns the times that suit the motion of a body; for a body at rest, those of 1 rad/s.
NaturalTimes natural_times(const motion::FreeBody& body);

/// Returns the times that suit the motion of a scene, or all the motions that it shows side by
/// side: the shortest step and the longest duration. Throws InvalidArgument as FreeBody does.
NaturalTimes natural_times(const Scene& scene);

/// Sets the step, the duration and the speed of the scene and its shots to their natural values
/// unless they were given.
void set_natural_times(Scene& scene);

/// Returns the samples per second of motion in a table of it: the frame rate if the user gave it,
/// or if the scene gives it and it suits the motion; otherwise the natural rate.
double sample_rate(const Scene& scene);

/// Replaces the body. The times, the title and the trail that the scene's author chose for the
/// previous body no longer apply. The new title is neutral.
void replace_body(Scene& scene, Body body);

}  // namespace twrench::scene
