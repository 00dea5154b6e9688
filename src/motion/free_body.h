#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "body/mass_properties.h"

namespace twrench {

/// A free rigid body with its initial condition: the constants of eq. (19)-(20). Body axes are any
/// axes fixed in the body; the inertia matrix need not be diagonal in them.
struct FreeBody {
  /// I in body axes, g cm^2.
  Eigen::Matrix3d inertia;
  /// I^-1.
  Eigen::Matrix3d inverse;
  /// L in space axes, g cm^2/s; constant.
  Eigen::Vector3d momentum;
  /// Angular velocity at t = 0, where X = Id, in body axes, rad/s. It is stored as given, because L
  /// = I omega is rounded, which matters close to the separatrix.
  Eigen::Vector3d omega;
  /// Principal moments and axes of the inertia matrix.
  PrincipalAxes principal;
};

/// Returns the body with X(0) = Id and the angular velocity omega in body axes, rad/s; L = I omega,
/// eq. (12).
inline FreeBody free_body(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega) {
  return {inertia, inertia.inverse(), inertia * omega, omega, principal_axes(inertia)};
}

/// The state of the motion at one time.
struct Sample {
  /// Time in s.
  double t;
  /// Attitude, space_from_body; its columns are the body axes in space.
  Eigen::Matrix3d X;
  /// Angular velocity in body axes, rad/s, as the method computes it from X.
  Eigen::Vector3d omega;
};

}  // namespace twrench
