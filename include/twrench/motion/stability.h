#pragma once

#include <twrench/body/mass_properties.h>
#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <array>
#include <optional>

namespace twrench::motion {

/// The stability of a steady rotation about a principal axis: the behaviour of a small tilt
/// according to Euler's equations, linearised about that rotation (docs/theory.md, "Which axis is
/// unstable").
struct Stability {
  /// The behaviour of the tilt.
  enum class Kind {
    unstable,  ///< It grows as exp(rate * t).
    stable,    ///< It wobbles as cos(rate * t).
    neutral,   ///< Neither: another axis has the same moment, to 1e-4, or the body is at rest.
  };
  /// The behaviour of the tilt.
  Kind kind = Kind::neutral;
  /// Rate of growth in 1/s or angular frequency in rad/s; 0 if neutral.
  double rate = 0;

  /// Returns the time in s in which an unstable tilt doubles, ln 2 / rate; infinite if neutral.
  double doubling_time() const;
  /// Returns the time in s of one turn of a stable wobble, 2 pi / rate; infinite if neutral.
  double period() const;
};

/// Returns the stability of a rotation at `omega` rad/s about axis k, for principal moments in g
/// cm^2, ascending. The rate follows from rate^2 = omega^2 |(I_k - I_i)(I_k - I_j)| / (I_i I_j).
/// Throws OutOfRange about "moments" unless they are positive and finite and about "omega" unless
/// it is finite; InvalidArgument about "moments" unless they are ascending, and about "axis" unless
/// it is one of the three.
Stability stability(const Eigen::Vector3d& moments, body::PrincipalAxes::Axis axis, double omega);

/// Returns the angular momentum in g cm^2/s of a wheel along the intermediate axis above which a
/// rotation at `omega` rad/s about that axis is stable, in the same direction: (I3 - I2) omega
/// (docs/theory.md, "A wheel and energy loss"). Throws OutOfRange and InvalidArgument about
/// "moments" and "omega" as stability() does.
double stabilizing_wheel(const Eigen::Vector3d& moments, double omega);

/// The tilt of a body relative to its angular momentum: the angle between L and the principal axis
/// that is nearest to L at t = 0, or the opposite direction of that axis after a flip.
class Tilt {
 public:
  /// A body at rest has no tilt. Throws nothing.
  explicit Tilt(const FreeBody& body);

  /// Returns the principal axis from which the tilt is measured.
  body::PrincipalAxes::Axis axis() const { return axis_; }

  /// Returns the rate in rad/s of the steady rotation about this axis with the same L: |L| / I_k,
  /// or, with a wheel, | |L| -+ h_k | / I_k.
  double steady_rate() const { return steady_rate_; }

  /// Returns the tilt in rad, from 0 to pi/2; 0 for a body at rest. Throws OutOfRange about "omega"
  /// unless that of the sample is finite.
  double of(const Sample& sample) const;

  /// Returns the angle in rad, from 0 to pi, between L and the direction of the axis that was
  /// nearest to L at t = 0; beyond pi/2 the body has turned over. Throws as of() does.
  double from_start(const Sample& sample) const;

  /// Returns the unit vector in body axes about which the body must turn, right-handed, to tilt
  /// further; 0 if it is not tilted. Throws as of() does.
  Eigen::Vector3d direction(const Sample& sample) const;

  /// The growth of a small tilt: the linearised tilt tends to amplitude * exp(rate * t).
  struct Growth {
    double amplitude;  ///< In rad.
    double rate;       ///< In 1/s.
  };

  /// Returns the growth of a small tilt of a rigid body until the first flip, or nothing if the
  /// axis is not unstable.
  std::optional<Growth> growth() const;

 private:
  /// Returns the momentum in principal axes.
  Eigen::Vector3d momentum(const Sample& sample) const;

  Eigen::Vector3d moments_;
  Eigen::Matrix3d axes_;                 ///< Body from principal axes.
  Eigen::Matrix3d momentum_from_omega_;  ///< From body axes to principal ones.
  Eigen::Vector3d start_;                ///< Momentum at t = 0 in principal axes.
  bool is_rigid_;
  Eigen::Vector3d momentum_;  ///< L, space axes.
  body::PrincipalAxes::Axis axis_ = body::PrincipalAxes::least;
  double steady_rate_ = 0;
};

}  // namespace twrench::motion
