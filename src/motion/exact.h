#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "math/elliptic.h"
#include "motion/free_body.h"

namespace twrench {

/// The motion of a free rigid body in closed form: the solution of eq. (19)-(20) with X(0) = Id,
/// at any t, for the same cost whatever t. Derived in docs/exact.md, whose equations are (E1) on.
///
/// Every positive definite inertia and every momentum: both sides of the separatrix and the
/// separatrix itself, symmetric bodies, the sphere, spin about a principal axis, rest.
/// The error of X grows as eps |omega| t, and beyond that only as the motion itself spreads an eps
/// of its initial velocity. Components of the momentum below 1e-145 |L| may count as zero.
class ExactMotion {
 public:
  /// What the momentum does, seen from the body.
  enum class Kind {
    steady,          ///< omega is constant: rest, or spin about a principal axis
    about_least,     ///< it circles the axis of least moment
    about_greatest,  ///< it circles the axis of greatest moment
    separatrix,      ///< it tends to the intermediate axis as t tends to either infinity
  };

  explicit ExactMotion(const FreeBody& body);

  Sample at(double t) const;  ///< t in s, of either sign

  Kind kind() const { return kind_; }

  /// Flips: sign changes of the component of omega along the intermediate axis. That axis swings
  /// from one side of the plane normal to L to the other and back: with `swing` near pi the body
  /// turns over, as the T-handle does; with `swing` near 0 it wobbles about a stable axis.
  struct Flips {
    double interval;             ///< s, from one to the next; infinite on the separatrix
    double first;                ///< s, of the first after t = 0; infinite where none is to come
    double asymptotic_interval;  ///< s, what `interval` tends to at the separatrix
    double swing;                ///< rad, from 0 to pi
  };
  /// Nothing for steady motion, nor for a symmetric body, which has no intermediate axis.
  std::optional<Flips> flips() const;

  /// The instants, s, of all flips with 0 < t <= t_end, ascending. Throws OutOfRange
  /// unless t_end is finite, and MotionError where there are more than 10^7.
  std::vector<double> flip_times(double t_end) const;

 private:
  /// What is constant of a motion that is not steady, in motion axes (a, b, c): L circles a, and b
  /// is the intermediate axis.
  struct Orbit {
    struct State {
      Eigen::Vector3d mu;       ///< m/G
      Eigen::Quaterniond turn;  ///< Rot(e_a, psi) P, eq. (E5), up to a factor and constant turns
    };
    State at(double t) const;

    elliptic::Jacobi jacobi;
    double m, mc;               ///< parameter k^2, and 1 - k^2
    double rate;                ///< lambda = du/dt, 1/s
    double phase;               ///< u at t = 0
    double spin;                ///< mean of dpsi/dt, rad/s
    Eigen::Vector3d amplitude;  ///< of mu = (a dn u, b sn u, c cn u)
    Eigen::Vector3d velocity;   ///< omega = velocity * mu, entry by entry, rad/s
  };

  static Orbit orbit(double G, const Eigen::Vector3d& mu, const Eigen::Vector3d& I, double D2);

  Kind kind_ = Kind::steady;
  Eigen::Vector3d omega0_;  ///< body axes, rad/s
  std::optional<Orbit> orbit_;
  Eigen::Matrix3d body_from_motion_;
  Eigen::Quaterniond motion_from_body_;
  Eigen::Quaterniond space_from_turned_;  ///< body_from_motion turn(0)^-1
};

}  // namespace twrench
