#pragma once

#include <Eigen/Core>
#include <atomic>
#include <memory>

#include "motion/reference_motion.h"
#include "scene/shown_recording.h"

namespace twrench::interchange {

/// Upper bounds, within an interval of time, for a turning attitude or direction. Infinite if they
/// are known only for shorter intervals.
struct RateBounds {
  double velocity = 0;      ///< Angular velocity in rad/s.
  double acceleration = 0;  ///< Covariant (geodesic) acceleration in rad/s^2.
};

/// The exact motion, or a recorded one, at the speed at which an animation plays it. Times are
/// those of the animation from its start, in s or in another unit, such as frames; "s of the
/// animation" below means that unit.
class PlayedMotion {
 public:
  /// `speed`: seconds of motion per second of the animation; `end`: its duration in s. If `stop`,
  /// which may be null, becomes true, the constructor and the functions below throw MotionError.
  /// `recording`, if it is not null, replaces the exact motion.
  PlayedMotion(const motion::FreeBody& body, double speed, double end,
               const std::atomic<bool>* stop = nullptr,
               std::shared_ptr<const scene::ShownRecording> recording = nullptr);

  /// Returns the sample of the motion that is shown at `time`.
  motion::Sample at(double time) const;

  /// Returns bounds for the attitude from `begin` to `end`.
  RateBounds attitude_rates(double begin, double end) const;

  /// Returns bounds for the direction of omega of the exact motion in space from `begin` to `end`.
  /// The bound for the acceleration also covers the second derivative of |omega|, relative to
  /// |omega|. Zero for a body at rest.
  RateBounds omega_rates(double begin, double end) const;

 private:
  /// Upper bounds for omega in body axes and its first two derivatives, per s of motion.
  struct Peaks {
    double velocity = 0, acceleration = 0, jerk = 0;
    double least_velocity = 0;  ///< Lower bound for |omega|; not positive if it is not known.
  };
  Peaks peaks(double begin, double end) const;
  Peaks curvatures_of_rigid_body() const;
  Peaks curvatures_with_interior() const;

  motion::FreeBody body_;
  motion::ReferenceMotion motion_;
  double speed_;
  std::shared_ptr<const scene::ShownRecording> recording_;
  const std::atomic<bool>* stop_;
  double least_rate_;  ///< Lower bound for |omega| at all times, in rad/s.
  Peaks curvatures_;   ///< Bounds of the second derivatives of the first three.
};

}  // namespace twrench::interchange
