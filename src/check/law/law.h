#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

#include "recording/rows.h"

namespace twrench::check {

/// How a program divides the gyroscopic term (I w) x w by the moments.
enum class Division { once, omitted, multiplied };

/// How a program computes the attitude from the rates.
enum class Kinematics {
  body_rates,         ///< X' = X hat(w)
  space_rates,        ///< X' = hat(w) X: the factors are in the wrong order
  integrated_angles,  ///< Euler angles, each the integral of the rate about its axis
};

/// A law of rotation, right or wrong, in body axes:
///   w' = a D((I w) x w) + I^-1 (b + X^T s) - c w - d |w| w,  X' = X hat(k w(t - delay)).
/// With the default numbers it is the motion of a free body.
struct Law {
  Eigen::Matrix3d inertia;                                       ///< I, in any unit
  double gyroscopic = 1;                                         ///< a
  Division division = Division::once;                            ///< D
  Eigen::Vector3d body_torque = Eigen::Vector3d::Zero();         ///< b, in units of I times rad/s^2
  Eigen::Vector3d space_torque = Eigen::Vector3d::Zero();        ///< s, likewise, space axes
  double damping = 0;                                            ///< c, 1/s
  double quadratic_damping = 0;                                  ///< d, 1/rad
  double speed_limit = std::numeric_limits<double>::infinity();  ///< of |w|, rad/s
  Kinematics kinematics = Kinematics::body_rates;
  double attitude_factor = 1;            ///< k
  double delay = 0;                      ///< s: the attitude follows the rates of that long before
  Eigen::Vector3i sequence = {2, 1, 0};  ///< axes of integrated angles, 0, 1, 2 for x, y, z
  /// Whether the second angle is beyond +-pi/2, in one of the two triples of angles that give an
  /// attitude.
  bool is_upside_down = false;
};

/// A state of the motion.
struct State {
  Eigen::Vector3d omega;  ///< rad/s, body axes
  Eigen::Quaterniond X;   ///< space_from_body
};

/// The rotation vector of a rotation, at most half a turn.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& q);

/// The state of a row.
State state_of(const recording::Row& row);

/// The state after a time in s, by the classical method of Runge and Kutta in steps of about `step`
/// rad: with 0.02, the error is about 1e-9 per radian. Numbers may overflow if the law is far from
/// the motion.
State advanced(const Law& law, const State& from, double time, double step);

}  // namespace twrench::check
