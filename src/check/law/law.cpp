#include "check/law/law.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::check {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// A state and the integral of its rates, or the derivative of both.
struct Numbers {
  Vector3d omega;
  Vector4d q;       ///< x, y, z, w, as Eigen stores quaternions
  Vector3d angles;  ///< integrals of the rates, rad

  Numbers plus(const Numbers& rate, double time) const {
    return {omega + time * rate.omega, q + time * rate.q, angles + time * rate.angles};
  }
};

/// The law as an ordinary differential equation.
class Equation {
 public:
  explicit Equation(const Law& law) : law_(law), inverse_(law.inertia.inverse()) {}

  Numbers operator()(const Numbers& at) const {
    const Quaterniond X(at.q);
    Quaterniond turn;
    turn.coeffs() << 0.5 * law_.attitude_factor * at.omega, 0;
    const bool in_space = law_.kinematics == Kinematics::space_rates;
    return {acceleration(at.omega, X), (in_space ? turn * X : X * turn).coeffs(), at.omega};
  }

 private:
  Vector3d acceleration(const Vector3d& w, const Quaterniond& X) const {
    const Vector3d torque = law_.body_torque + X.conjugate() * law_.space_torque;
    const double speed = w.norm();
    const Vector3d free = law_.gyroscopic * divided((law_.inertia * w).cross(w)) +
                          inverse_ * torque - (law_.damping + law_.quadratic_damping * speed) * w;
    // At the limit only the direction changes.
    const double faster = w.dot(free);
    if (speed < law_.speed_limit || faster <= 0) return free;
    return free - faster / (speed * speed) * w;
  }

  Vector3d divided(const Vector3d& term) const {
    switch (law_.division) {
      case Division::once:
        return inverse_ * term;
      case Division::omitted:
        return term;
      case Division::multiplied:
        return law_.inertia * term;
    }
    return term;
  }

  const Law& law_;
  Matrix3d inverse_;
};

/// One step of the classical method of order 4.
Numbers stepped(const Equation& rate_of, const Numbers& at, double h) {
  const Numbers k1 = rate_of(at);
  const Numbers k2 = rate_of(at.plus(k1, h / 2));
  const Numbers k3 = rate_of(at.plus(k2, h / 2));
  const Numbers k4 = rate_of(at.plus(k3, h));
  return at.plus(k1, h / 6).plus(k2, h / 3).plus(k3, h / 3).plus(k4, h / 6);
}

Vector3d limited(const Law& law, const Vector3d& omega) {
  const double speed = omega.norm();
  return speed > law.speed_limit ? Vector3d(law.speed_limit / speed * omega) : omega;
}

Numbers integrated(const Law& law, const State& from, double time, double step) {
  constexpr double most = 2000;  // a law that turns farther between rows is of no use
  Numbers at{limited(law, from.omega), from.X.coeffs(), Vector3d::Zero()};
  const double turn = std::abs(time) * from.omega.norm() * std::max(1.0, law.attitude_factor);
  const auto count = static_cast<int>(std::ceil(std::clamp(turn / step, 1.0, most)));
  const Equation equation(law);
  for (int i = 0; i < count; ++i) {
    at = stepped(equation, at, time / count);
    at.omega = limited(law, at.omega);
  }
  return at;
}

/// The attitude whose Euler angles have grown by the integrals of the rates about their axes.
Quaterniond with_grown_angles(const Law& law, const Quaterniond& X, const Vector3d& growth) {
  const Eigen::Vector3i& axes = law.sequence;
  constexpr double half_turn = std::numbers::pi;
  Vector3d angles = X.toRotationMatrix().eulerAngles(axes[0], axes[1], axes[2]);
  if (law.is_upside_down != (std::cos(angles[1]) < 0))
    angles = Vector3d(angles[0] + half_turn, half_turn - angles[1], angles[2] + half_turn);
  Quaterniond turned = Quaterniond::Identity();
  for (int i = 0; i < 3; ++i) {
    turned = turned * Eigen::AngleAxisd(angles[i] + growth[axes[i]], Vector3d::Unit(axes[i]));
  }
  return turned;
}

}  // namespace

Vector3d rotation_vector(const Quaterniond& q) {
  const Eigen::AngleAxisd turn(q);
  return turn.angle() * turn.axis();
}

State state_of(const recording::Row& row) { return {row.omega, Quaterniond(row.X).normalized()}; }

State advanced(const Law& law, const State& from, double time, double step) {
  State start = from;
  if (law.delay != 0) start.omega = integrated(law, from, -law.delay, step).omega;
  const Numbers end = integrated(law, start, time, step);
  State result{end.omega, Quaterniond(end.q).normalized()};
  if (law.kinematics == Kinematics::integrated_angles)
    result.X = with_grown_angles(law, from.X, end.angles);
  return result;
}

}  // namespace twrench::check
