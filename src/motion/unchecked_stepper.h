#pragma once

#include <twrench/motion/stepper.h>

// The functions of stepper.h without their checks. If a method that leaves SO(3) overflows, its
// propagator reports that the motion has diverged.

namespace twrench::motion::unchecked {

Eigen::Vector3d angular_velocity(const FreeBody& body, const Method& method,
                                 const Eigen::Matrix3d& X);

Step take_step(const FreeBody& body, const Method& method, const Eigen::Matrix3d& X, double h);

}  // namespace twrench::motion::unchecked
