#pragma once

#include <Eigen/Core>
#include <array>

#include "motion/free_body.h"
#include "motion/method.h"

namespace twrench {

/// The motion about one instant as a Taylor series in time, of the body momentum and of one angle.
///
/// With mu the direction of the body momentum, in principal axes, and n = mu at the instant,
///   mu' = G mu x (I^-1 mu),   X(0)^T X(t) = exp(psi hat(n)) (least rotation of mu(t) to n),
///   psi' = omega . (mu + n) / (1 + mu . n),
/// eq. (E2), (E5) and (E6) of docs/exact.md with n for the axis. So four convolutions make the
/// coefficients, where omega with a quaternion takes fifteen. What psi' divides by is 2 at the
/// instant and vanishes nowhere within a step.
class TaylorSeries {
 public:
  /// In principal axes.
  struct State {
    Eigen::Matrix3d X;   ///< space_from_principal
    Eigen::Vector3d mu;  ///< m/|m|; zero for a body at rest
  };

  /// Throws OutOfRange unless the order is even and 2 to largest_taylor_order.
  TaylorSeries(const FreeBody& body, const Taylor& method);

  State state_of(const Eigen::Matrix3d& X, const Eigen::Vector3d& momentum) const;
  Sample sample(double t, const State& state) const;

  /// Moves the series to another instant.
  void expand(const State& state);

  /// The state h seconds later. The energy is that of t = 0 again: the one direction in which
  /// errors grow, near the separatrix, is across the surfaces of equal energy.
  State at(double h) const;

  /// The larger of what the terms of the last two orders add to X h seconds later, in the Frobenius
  /// norm. Two, because motions with a symmetry in time have every other coefficient zero.
  double last_terms(double h) const;

  /// The longest h > 0, s, for which last_terms(h) is within `tolerance`: known before the step is
  /// taken, so that none is rejected. After Jorba and Zou, Experimental Mathematics 14 (2005).
  double reach(double tolerance) const;

 private:
  /// Two lanes that one instruction handles.
  using Pair = double __attribute__((vector_size(16)));
  static constexpr std::size_t capacity = largest_taylor_order + 1;

  double term(std::size_t k) const;
  Eigen::Vector3d with_initial_energy(const Eigen::Vector3d& mu) const;

  std::size_t order_;
  Eigen::Matrix3d axes_;      ///< body_from_principal
  double unit_ = 0;           ///< of time, s: I_1/G
  Eigen::Vector3d velocity_;  ///< omega = velocity * mu, entry by entry, per unit of time
  Eigen::Vector3d excess_;    ///< of eq. (E1): D_2/G^2 = excess . mu^2
  double energy_ = 0;         ///< D_2/G^2 at t = 0
  State start_;
  std::array<Pair, capacity> m12_, m3psi_;  ///< coefficients of (mu_1, mu_2) and (mu_3, psi)
};

}  // namespace twrench
