#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "body/mass_properties.h"

namespace twrench {

/// A rigid body that turns freely: eq. (19)-(20) with its constants. Body axes are any axes fixed
/// in the body; the inertia need not be diagonal in them.
struct FreeBody {
  Eigen::Matrix3d inertia;   ///< I, body axes, g cm^2
  Eigen::Matrix3d inverse;   ///< I^-1
  Eigen::Vector3d momentum;  ///< L, space axes, g cm^2/s; constant
  Eigen::Vector3d omega;     ///< at t = 0, where X = Id, body axes, rad/s; as it was given, where
                             ///< L is I omega rounded: close to the separatrix that tells
  PrincipalAxes principal;   ///< of the inertia
};

/// The body with X(0) = Id and angular velocity omega (body axes, rad/s): L = I omega, eq. (12).
inline FreeBody free_body(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega) {
  return {inertia, inertia.inverse(), inertia * omega, omega, principal_axes(inertia)};
}

/// The motion at one instant.
struct Sample {
  double t;               ///< s
  Eigen::Matrix3d X;      ///< space_from_body; columns are the body axes in space
  Eigen::Vector3d omega;  ///< body axes, rad/s, as the method itself computes it from X
};

}  // namespace twrench
