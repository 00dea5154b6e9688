#pragma once

#include <twrench/motion/exact.h>

#include <Eigen/Core>

namespace twrench::interchange {

/// Upper bounds, within an interval of time, for a turning attitude or direction.
struct RateBounds {
  double velocity = 0;      ///< Angular velocity in rad/s.
  double acceleration = 0;  ///< Covariant (geodesic) acceleration in rad/s^2.
};

/// The exact motion at the speed at which an animation plays it. Times are those of the animation,
/// in s from its start.
class PlayedMotion {
 public:
  /// `speed`: seconds of motion per second of the animation.
  PlayedMotion(const motion::FreeBody& body, double speed);

  /// Returns the sample of the motion that is shown at `time`.
  motion::Sample at(double time) const { return exact_.at(speed_ * time); }

  /// Returns bounds for the attitude from `begin` to `end`.
  RateBounds attitude_rates(double begin, double end) const;

  /// Returns bounds for the direction of omega in space from `begin` to `end`. The bound for the
  /// acceleration also covers the second derivative of |omega|, relative to |omega|. Zero for a
  /// body at rest.
  RateBounds omega_rates(double begin, double end) const;

 private:
  /// Upper bounds for omega in body axes and its first two derivatives, per s of motion.
  struct Peaks {
    double velocity = 0, acceleration = 0, jerk = 0;
  };
  Peaks peaks(double begin, double end) const;

  motion::ExactMotion exact_;
  double speed_;
  Eigen::Matrix3d principal_from_body_;
  Eigen::Vector3d coupling_;  ///< c of Euler's equations: omega_x' = c_x omega_y omega_z.
  double least_rate_;         ///< Lower bound for |omega|, in rad/s.
  Peaks curvatures_;          ///< Bounds of the second derivatives of these three.
};

}  // namespace twrench::interchange
