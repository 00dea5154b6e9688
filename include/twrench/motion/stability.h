#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <array>
#include <optional>

namespace twrench::motion {

/// What a small tilt of a steadily rotating body does: the solution of Euler's equations linearised
/// about a rotation about a principal axis (docs/theory.md, "Which axis is unstable").
struct Stability {
  /// What becomes of the tilt.
  enum class Kind {
    unstable,  ///< It grows as exp(rate * t).
    stable,    ///< It wobbles as cos(rate * t).
    neutral,   ///< Neither: the axis is not the only one with its moment, or the body is at rest.
  };
  /// What becomes of the tilt.
  Kind kind = Kind::neutral;
  /// Rate of growth in 1/s or angular frequency in rad/s; 0 if neutral.
  double rate = 0;

  /// Returns the time in s in which an unstable tilt doubles, ln 2 / rate; infinite if neutral.
  double doubling_time() const;
  /// Returns the time in s of one turn of a stable wobble, 2 pi / rate; infinite if neutral.
  double period() const;
};

/// Returns the stability of a rotation at `omega` rad/s about the axis with that index, for
/// principal moments in g cm^2, in any order: rate^2 = omega^2 |(I_k - I_i)(I_k - I_j)| / (I_i
/// I_j). Throws OutOfRange about "moments" unless they are positive and finite, about "axis" unless
/// it is 0, 1 or 2, and about "omega" unless it is finite.
Stability stability(const Eigen::Vector3d& moments, int axis, double omega);

/// The tilt of a body against its angular momentum: the angle between L and the principal axis that
/// is nearest to L at t = 0, or the opposite direction of that axis after a flip.
class Tilt {
 public:
  /// Throws nothing; a body at rest has no tilt.
  explicit Tilt(const FreeBody& body);

  /// Returns the index of the axis in body.principal(), which lists the least moment first.
  int axis() const { return axis_; }

  /// Returns the rate in rad/s of the steady rotation about this axis with the same L: |L| / I_k.
  double steady_rate() const { return steady_rate_; }

  /// Returns the tilt in rad, from 0 to pi/2; 0 for a body at rest. Throws OutOfRange about "omega"
  /// unless that of the sample is finite.
  double of(const Sample& sample) const;

  /// Returns the unit vector in body axes about which the body must turn, right-handed, to tilt
  /// further; 0 if it is not tilted. Throws as of() does.
  Eigen::Vector3d direction(const Sample& sample) const;

  /// The growth of a small tilt: the linearised tilt tends to amplitude * exp(rate * t).
  struct Growth {
    double amplitude;  ///< In rad.
    double rate;       ///< In 1/s.
  };

  /// Returns the growth of a small tilt until the first flip, or nothing if the axis is not
  /// unstable.
  std::optional<Growth> growth() const;

 private:
  Eigen::Vector3d moments_;
  Eigen::Matrix3d axes_;                 ///< Body from principal axes.
  Eigen::Matrix3d momentum_from_omega_;  ///< From body axes to principal ones.
  Eigen::Vector3d start_;                ///< Momentum at t = 0 in principal axes.
  int axis_ = 0;
  double steady_rate_ = 0;
};

}  // namespace twrench::motion
