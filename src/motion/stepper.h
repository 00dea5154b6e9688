#pragma once

#include <Eigen/Core>

#include "motion/free_body.h"
#include "motion/method.h"

namespace twrench {

/// The angular velocity, body axes, rad/s, that belongs to X: eq. (19), omega = I^-1 X^T L. A
/// method that leaves SO(3) takes the inverse in place of the transpose, as eq. (24) prints it.
Eigen::Vector3d angular_velocity(const FreeBody& body, const Method& method,
                                 const Eigen::Matrix3d& X);

/// One step.
struct Step {
  Eigen::Matrix3d X;
  double error;     ///< E = sqrt(trace(dW^T dW)) of an embedded pair, section 4.5; last_terms
                    ///< of a series; else 0.
                    ///< Infinite where h is too long for the method: then X means nothing.
  int evaluations;  ///< of omega
};

/// One step of h seconds (negative ones too) from X, of a method that takes steps.
Step take_step(const FreeBody& body, const Method& method, const Eigen::Matrix3d& X, double h);

}  // namespace twrench
