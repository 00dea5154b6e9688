#pragma once

#include <optional>

#include "scene/scene.h"
#include "timeline/frame_change.h"

namespace twrench::timeline {

/// The move of the camera at the start of a shot. Times are in s of video after that start.
struct CameraMove {
  /// The camera of the previous shot.
  scene::CameraPath from;
  /// Time in the previous shot at the start of this one, in s.
  double from_time = 0.0;
  /// Length in s.
  double length = 0.0;
  /// The change of the frame of reference; nothing if both shots have the same, or different
  /// motions.
  std::optional<FrameChange> change;
  /// Time of the motion in s at the start of the shot.
  double start = 0.0;
  /// Seconds of motion per second of video.
  scene::SpeedCurve speed;

  /// Returns how far the camera has moved, 0 to 1.
  double share(double time) const;

  /// Returns the last time up to `latest` at which the motion was not later than `t`.
  double time_of(double t, double latest) const;
};

}  // namespace twrench::timeline
