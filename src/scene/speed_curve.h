#pragma once

#include <vector>

namespace twrench::scene {

/// A speed that changes with time: linear between points, and constant before the first and after
/// the last.
struct SpeedCurve {
  struct Point {
    double time;   ///< Seconds of video.
    double speed;  ///< Seconds of motion per second of video; 0 freezes the motion.
  };
  /// At least one, in ascending order of time.
  std::vector<Point> points;

  /// Returns the speed at that time.
  double at(double time) const;
  /// Returns the seconds of motion from time 0 to `time`, >= 0, in closed form.
  double integral(double time) const;
  /// Returns the greatest speed.
  double fastest() const;
};

}  // namespace twrench::scene
