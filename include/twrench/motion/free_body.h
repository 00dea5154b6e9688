#pragma once

#include <twrench/body/mass_properties.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

namespace twrench::motion {

/// Parts that move within a body. They do not change L (docs/theory.md, "A wheel and
/// energy loss").
struct Interior {
  /// Angular momentum h of a wheel relative to the body in g cm^2/s, constant in body axes.
  Eigen::Vector3d wheel = Eigen::Vector3d::Zero();
  /// Time constant in s with which a small nutation about the axis of greatest moment would decay
  /// without a wheel; infinite if no energy is lost.
  double energy_loss_time = std::numeric_limits<double>::infinity();
};

/// A free rigid body with its initial condition: the constants of eq. (19)-(20). Body axes are any
/// axes fixed in the body; the inertia matrix need not be diagonal in them.
///
/// With an Interior the body momentum m = X^T L turns X at the rate omega = w + a (m x w), where
/// w = I^-1 (m - h) and a >= 0 is given by the time constant of the energy loss. L stays constant;
/// the energy w . I w / 2 falls by a |m x w|^2 per second.
class FreeBody {
 public:
  /// Makes a body with `inertia` (body axes, g cm^2) that at t = 0 has the angular velocity `omega`
  /// (body axes, rad/s) and the attitude X(0) = `attitude`. In the specification, X(0) = Id. Any
  /// other attitude extends it: X(t) is `attitude` times the motion from Id, and L is rotated by
  /// `attitude`.
  ///
  /// Throws InvalidArgument about "inertia" unless it is finite, symmetric to round-off and
  /// positive definite, about "omega" unless it is finite, and about "attitude" unless it is a
  /// proper rotation to 1e-9. The error is an OutOfRange if a single number is out of bounds: the
  /// least moment or a component of omega. Throws OutOfRange about "wheel" unless it is finite, and
  /// about "energy_loss_time" unless it exceeds the bound above which a nutation decays
  /// exponentially with it; InvalidArgument about "energy_loss_time" if two axes share the greatest
  /// moment.
  FreeBody(const Eigen::Matrix3d& inertia, const Eigen::Vector3d& omega,
           const Eigen::Matrix3d& attitude = Eigen::Matrix3d::Identity(),
           const Interior& interior = {});

  /// Returns the same body with another angular velocity at t = 0 (body axes, rad/s). The principal
  /// axes are not recomputed. Throws about "omega" and "energy_loss_time" as the constructor does.
  FreeBody with_omega(const Eigen::Vector3d& omega) const;

  /// Returns the same body with another angular velocity and attitude at t = 0. Throws as
  /// with_omega() does, and about "attitude" as the constructor does.
  FreeBody with_start(const Eigen::Vector3d& omega, const Eigen::Matrix3d& attitude) const;

  /// I in body axes, g cm^2.
  const Eigen::Matrix3d& inertia() const { return inertia_; }
  /// I^-1.
  const Eigen::Matrix3d& inverse() const { return inverse_; }
  /// L = X (I omega + h), eq. (12), in space axes, g cm^2/s; constant.
  const Eigen::Vector3d& momentum() const { return momentum_; }
  /// The angular velocity w at t = 0 in body axes, rad/s, exactly as given: near the separatrix,
  /// recomputing it from the rounded I omega would matter.
  const Eigen::Vector3d& omega() const { return omega_; }
  /// X(0), space_from_body.
  const Eigen::Matrix3d& attitude() const { return attitude_; }
  /// I omega + h at t = 0, in body axes, g cm^2/s.
  const Eigen::Vector3d& body_momentum() const { return body_momentum_; }
  /// Principal moments and axes of the inertia matrix.
  const body::PrincipalAxes& principal() const { return principal_; }

  /// Returns an upper bound of |omega| in rad/s at all times: |m - h| <= |L| + |h|.
  double fastest_rate() const;
  /// Returns omega at t = 0: the given one plus the contribution of the energy loss.
  Eigen::Vector3d initial_rate() const;
  /// The parts that move within the body.
  const Interior& interior() const { return interior_; }
  /// Returns whether nothing moves within the body.
  bool is_rigid() const { return is_rigid_; }
  /// The coefficient a of the rate omega in s/(g cm^2); 0 if no energy is lost.
  double energy_loss() const { return energy_loss_; }
  // Functions of a body momentum m in g cm^2/s. They throw OutOfRange about "m" unless it is
  // finite.

  /// Returns w = I^-1 (m - h) in rad/s.
  Eigen::Vector3d rigid_velocity(const Eigen::Vector3d& m) const;
  /// Returns omega = w + a (m x w) in rad/s: X' = X hat(omega).
  Eigen::Vector3d turning_rate(const Eigen::Vector3d& m) const;
  /// Returns the energy w . (m - h) / 2 in g cm^2/s^2.
  double energy(const Eigen::Vector3d& m) const;

 private:
  void set_start(const Eigen::Vector3d& omega, const Eigen::Matrix3d& attitude);

  Eigen::Matrix3d inertia_;
  body::PrincipalAxes principal_;
  Eigen::Matrix3d inverse_;
  Eigen::Vector3d omega_;
  Eigen::Matrix3d attitude_;
  Eigen::Vector3d body_momentum_;
  Eigen::Vector3d momentum_;
  Interior interior_;
  double energy_loss_ = 0;
  bool is_rigid_ = true;
};

/// The state of the motion at one time.
struct Sample {
  /// Time in s.
  double t;
  /// Attitude, space_from_body; its columns are the body axes in space.
  Eigen::Matrix3d X;
  /// Angular velocity omega of X, in body axes, rad/s, as the method computes it from X. At t = 0
  /// it is exactly the given one, unless energy is lost.
  Eigen::Vector3d omega;

  /// Returns the unit quaternion of X with w >= 0; q and -q are the same attitude. Like X it maps
  /// body axes to space axes. It is unaligned, because the alignment of Eigen::Quaterniond depends
  /// on compiler flags, and converts to that type. Throws OutOfRange about "X" unless it is finite.
  Eigen::Quaternion<double, Eigen::DontAlign> quaternion() const;
};

}  // namespace twrench::motion
