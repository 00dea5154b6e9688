#pragma once

#include <twrench/body/mass_properties.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace twrench::motion {

/// A free rigid body with its initial condition: the constants of eq. (19)-(20). Body axes are any
/// axes fixed in the body; the inertia matrix need not be diagonal in them.
class FreeBody {
 public:
  /// The body with `inertia` (body axes, g cm^2), and at t = 0 the angular velocity `omega` (body
  /// axes, rad/s) and the attitude X(0) = `attitude`. The specification has X(0) = Id; another
  /// attitude extends it: X(t) is `attitude` times the motion from Id, and L turns with it.
  ///
  /// Throws InvalidArgument about "inertia" unless that is finite, symmetric to round-off and
  /// positive definite, about "omega" unless that is finite, and about "attitude" unless that is a
  /// proper rotation to 1e-9; OutOfRange where the bound is that of one number, the least moment or
  /// a component of omega.
  FreeBody(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega,
           const Eigen::Matrix3d& attitude = Eigen::Matrix3d::Identity());

  /// Returns the same body with another angular velocity at t = 0 (body axes, rad/s). Its principal
  /// axes are not computed again. Throws about "omega" as the constructor does.
  FreeBody with_omega(const Eigen::Vector3d& omega) const;

  /// Returns the same body with another angular velocity and attitude at t = 0. Throws as
  /// with_omega(), and about "attitude" as the constructor does.
  FreeBody with_start(const Eigen::Vector3d& omega, const Eigen::Matrix3d& attitude) const;

  /// I in body axes, g cm^2.
  const Eigen::Matrix3d& inertia() const { return inertia_; }
  /// I^-1.
  const Eigen::Matrix3d& inverse() const { return inverse_; }
  /// L = X I omega, eq. (12), in space axes, g cm^2/s; constant.
  const Eigen::Vector3d& momentum() const { return momentum_; }
  /// The angular velocity at t = 0 in body axes, rad/s, exactly as it was given: near the
  /// separatrix the rounding of I omega would matter.
  const Eigen::Vector3d& omega() const { return omega_; }
  /// X(0), space_from_body.
  const Eigen::Matrix3d& attitude() const { return attitude_; }
  /// I omega at t = 0, in body axes, g cm^2/s.
  const Eigen::Vector3d& body_momentum() const { return body_momentum_; }
  /// Principal moments and axes of the inertia matrix.
  const body::PrincipalAxes& principal() const { return principal_; }

 private:
  void set_start(const Eigen::Vector3d& omega, const Eigen::Matrix3d& attitude);

  Eigen::Matrix3d inertia_;
  body::PrincipalAxes principal_;
  Eigen::Matrix3d inverse_;
  Eigen::Vector3d omega_;
  Eigen::Matrix3d attitude_;
  Eigen::Vector3d body_momentum_;
  Eigen::Vector3d momentum_;
};

/// The state of the motion at one time.
struct Sample {
  /// Time in s.
  double t;
  /// Attitude, space_from_body; its columns are the body axes in space.
  Eigen::Matrix3d X;
  /// Angular velocity in body axes, rad/s, as the method computes it from X; at t = 0 exactly what
  /// was given.
  Eigen::Vector3d omega;

  /// Returns the unit quaternion of X with w >= 0; q and -q are the same attitude. Like X it maps
  /// body axes to space axes. It converts to Eigen::Quaterniond, whose alignment depends on
  /// compiler flags. Throws OutOfRange about "X" unless it is finite.
  Eigen::Quaternion<double, Eigen::DontAlign> quaternion() const;
};

}  // namespace twrench::motion
