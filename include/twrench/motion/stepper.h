#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/motion/method.h>

#include <Eigen/Core>

namespace twrench::motion {

/// Returns the angular velocity in body axes, rad/s, for the attitude X: eq. (19), omega = I^-1 X^T
/// L. A method that leaves SO(3) uses the inverse instead of the transpose, as eq. (24) prints it.
/// Throws OutOfRange about "X" unless it is finite.
Eigen::Vector3d angular_velocity(const FreeBody& body, const Method& method,
                                 const Eigen::Matrix3d& X);

/// The result of one step.
struct Step {
  /// Attitude at the end of the step.
  Eigen::Matrix3d X;
  /// Error estimate: for an embedded pair E = sqrt(trace(dW^T dW)), section 4.5; for a series
  /// last_terms; otherwise 0. Infinite if h is too long for the method; X is then meaningless.
  double error;
  /// Evaluations of omega.
  int evaluations;
};

/// Takes one step of h seconds (which may be negative) from X with any method. Throws OutOfRange
/// about "X" or "h" unless it is finite.
Step take_step(const FreeBody& body, const Method& method, const Eigen::Matrix3d& X, double h);

}  // namespace twrench::motion
