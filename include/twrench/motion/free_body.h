#pragma once

#include <twrench/body/mass_properties.h>

#include <Eigen/Core>

namespace twrench::motion {

/// A free rigid body with its initial condition: the constants of eq. (19)-(20). Body axes are any
/// axes fixed in the body; the inertia matrix need not be diagonal in them.
class FreeBody {
 public:
  /// The body with X(0) = Id, `inertia` (body axes, g cm^2) and the angular velocity `omega` (body
  /// axes, rad/s). Throws InvalidArgument about "inertia" unless that is finite, symmetric to
  /// round-off and positive definite, and about "omega" unless that is finite; OutOfRange where the
  /// bound is that of one number, the least moment or a component of omega.
  FreeBody(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega);

  /// I in body axes, g cm^2.
  const Eigen::Matrix3d& inertia() const { return inertia_; }
  /// I^-1.
  const Eigen::Matrix3d& inverse() const { return inverse_; }
  /// L = I omega, eq. (12), in space axes, g cm^2/s; constant.
  const Eigen::Vector3d& momentum() const { return momentum_; }
  /// The angular velocity at t = 0 in body axes, rad/s, exactly as it was given: near the
  /// separatrix the rounding of I omega would matter.
  const Eigen::Vector3d& omega() const { return omega_; }
  /// Principal moments and axes of the inertia matrix.
  const body::PrincipalAxes& principal() const { return principal_; }

 private:
  Eigen::Matrix3d inertia_;
  Eigen::Vector3d omega_;
  body::PrincipalAxes principal_;
  Eigen::Matrix3d inverse_;
  Eigen::Vector3d momentum_;
};

/// The state of the motion at one time.
struct Sample {
  /// Time in s.
  double t;
  /// Attitude, space_from_body; its columns are the body axes in space.
  Eigen::Matrix3d X;
  /// Angular velocity in body axes, rad/s, as the method computes it from X; at t = 0, where X is
  /// the identity, exactly what was given.
  Eigen::Vector3d omega;
};

}  // namespace twrench::motion
