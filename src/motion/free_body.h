#pragma once

#include <Eigen/Core>

#include "body/mass_properties.h"

namespace twrench {

/// A free rigid body with its initial condition: the constants of eq. (19)-(20). Body axes are any
/// axes fixed in the body; the inertia matrix need not be diagonal in them.
class FreeBody {
 public:
  /// The body with X(0) = Id, `inertia` (body axes, g cm^2) and the angular velocity `omega` (body
  /// axes, rad/s). Throws UsageError about "inertia" unless that is finite, symmetric to round-off
  /// and positive definite, and about "omega" unless that is finite; OutOfRange where the bound is
  /// that of one number, the least moment or a component of omega.
  FreeBody(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega);

  const Eigen::Matrix3d& inertia() const { return inertia_; }  ///< I in body axes, g cm^2.
  const Eigen::Matrix3d& inverse() const { return inverse_; }  ///< I^-1.
  const Eigen::Vector3d& momentum() const {
    return momentum_;
  }  ///< L = I omega, eq. (12), in space
     ///< axes, g cm^2/s; constant
  /// At t = 0, body axes, rad/s; as it was given, where L is I omega rounded: close to the
  /// separatrix that tells.
  const Eigen::Vector3d& omega() const { return omega_; }
  /// Principal moments and axes of the inertia matrix.
  const PrincipalAxes& principal() const { return principal_; }

 private:
  Eigen::Matrix3d inertia_;
  Eigen::Vector3d omega_;
  PrincipalAxes principal_;
  Eigen::Matrix3d inverse_;
  Eigen::Vector3d momentum_;
};

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
