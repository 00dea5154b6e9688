#pragma once

#include <twrench/motion/free_body.h>

#include <Eigen/Core>
#include <array>

#include "motion/scheme.h"
#include "motion/series_steps.h"

namespace twrench::motion {

/// The motion about an expansion point as a Taylor series in time of the body momentum and one
/// angle.
///
/// With mu the direction of the body momentum in principal axes and n = mu at the expansion point,
///  mu' = G mu x (I^-1 mu),   X(0)^T X(t) = exp(psi hat(n)) (smallest rotation from mu(t) to n),
///  psi' = omega . (mu + n) / (1 + mu . n),
/// which are eq. (E2), (E5) and (E6) of docs/exact.md with n as the axis. The coefficients thus
/// require four convolutions, whereas omega with a quaternion requires fifteen. The denominator of
/// psi' is 2 at the expansion point and does not vanish within a step.
class TaylorSeries {
 public:
  /// The state in principal axes.
  struct State {
    Eigen::Matrix3d X;   ///< Attitude space_from_principal.
    Eigen::Vector3d mu;  ///< Unit vector m/|m|; zero for a body at rest.
  };

  /// Throws OutOfRange unless the order is even and 2 to max_taylor_order.
  TaylorSeries(const FreeBody& body, const Taylor& method);

  /// Returns the state of an attitude space_from_body with the body momentum in g cm^2/s.
  State state_of(const Eigen::Matrix3d& X, const Eigen::Vector3d& momentum) const;
  /// Returns the sample of a state at the time t in s.
  Sample sample(double t, const State& state) const;

  /// Moves the expansion point.
  void expand(const State& state);

  /// Returns the state h seconds after the expansion point. Its energy is projected to that at t =
  /// 0, because near the separatrix only errors across the surfaces of constant energy grow.
  State at(double h) const;

  /// Returns the larger of the contributions of the last two orders to X after h seconds, in the
  /// Frobenius norm.
  double last_terms(double h) const { return last().after(h / unit_); }

  /// Returns the longest h > 0 in s for which last_terms(h) is within `tolerance`.
  double max_step(double tolerance) const { return unit_ * last().longest_time(tolerance); }

 private:
  /// Two SIMD lanes.
  using Pair = double __attribute__((vector_size(16)));
  static constexpr std::size_t capacity = max_taylor_order + 1;

  double term(std::size_t k) const;
  LastTerms last() const;
  Eigen::Vector3d with_initial_energy(const Eigen::Vector3d& mu) const;

  std::size_t order_;
  Eigen::Matrix3d axes_;      ///< body_from_principal.
  double unit_ = 0;           ///< Unit of time in s: I_1/G.
  Eigen::Vector3d velocity_;  ///< omega = velocity * mu, componentwise, per unit of time.
  Eigen::Vector3d excess_;    ///< Coefficients of eq. (E1): D_2/G^2 = excess . mu^2.
  double energy_ = 0;         ///< D_2/G^2 at t = 0.
  State start_;
  std::array<Pair, capacity> m12_, m3psi_;  ///< Coefficients of (mu_1, mu_2) and (mu_3, psi).
};

}  // namespace twrench::motion
