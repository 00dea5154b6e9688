#include <twrench/math/so3.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/require.h"
#include "math/so3_formulas.h"
#include "motion/exact_solution.h"
#include "motion/interior_series.h"
#include "motion/taylor.h"
#include "motion/unchecked.h"

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// In rad. dexpinv is singular at |u| = 2 pi and accurate up to this bound.
constexpr double longest_turn = 6.0;

constexpr double infinite = std::numeric_limits<double>::infinity();

using Stages = std::array<Vector3d, 6>;

/// Returns zeros, so that no code path leaves a stage uninitialised. Eigen does not initialise its
/// vectors.
Stages zero_stages() {
  Stages s;
  s.fill(Vector3d::Zero());
  return s;
}

/// Returns the sum of row[j] * s[j] over the first `count` stages.
Vector3d weighted_sum(const TableauRow& row, const Stages& s, int count) {
  Vector3d sum = row[0] * s[0];
  for (std::size_t j = 1; j < static_cast<std::size_t>(count); ++j) sum += row[j] * s[j];
  return sum;
}

/// Returns exp(-hat(u)) m, the body momentum m after the body has rotated by exp(hat(u)).
Vector3d turned_back(const Vector3d& u, const Vector3d& m) {
  return so3::Formulas::exp_times(so3::Formulas::angle_functions(u), -u, m);
}

Vector3d body_momentum(const FreeBody& body, bool linear, const Matrix3d& X) {
  return linear ? Vector3d(X.inverse() * body.momentum())
                : Vector3d(X.transpose() * body.momentum());
}

/// Sections 4.1 to 4.5: s_k = I^-1 exp(-h sum_j a_kj S_j) W^T L, followed by dexpinv for the
/// corrected methods.
template <class Rate>
[[gnu::flatten]] Step step(const FreeBody& body, Rate rate, const RungeKutta& method,
                           const Matrix3d& X, double h) {
  const Tableau& tableau = method.tableau;
  const Vector3d momentum = body_momentum(body, method.update == Update::linear, X);
  Stages s = zero_stages();
  s[0] = rate(momentum);
  for (int k = 1; k < tableau.stages; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const Vector3d u = h * weighted_sum(tableau.a[row], s, k);
    const so3::AngleFunctions f = so3::Formulas::angle_functions(u);
    s[row] = rate(so3::Formulas::exp_times(f, -u, momentum));
    if (method.update != Update::munthe_kaas) continue;
    if (!(u.squaredNorm() < longest_turn * longest_turn)) return {X, infinite, k + 1};
    s[row] = so3::Formulas::dexpinv(f, u, s[row]);
  }
  const Vector3d u = h * weighted_sum(tableau.weights, s, tableau.stages);
  if (method.update == Update::linear) return {X + X * so3::Formulas::hat(u), 0.0, tableau.stages};
  const Matrix3d rotation = so3::Formulas::exp(u);
  if (!tableau.embedded_pair) return {X * rotation, 0.0, tableau.stages};
  // |W' - Z'| = |W (exp u - exp v)| = |exp u - exp v|, because W is orthogonal.
  const Vector3d v = h * weighted_sum(tableau.embedded, s, tableau.stages);
  return {X * rotation, (rotation - so3::Formulas::exp(v)).norm(), tableau.stages};
}

template <class Rate>
[[gnu::flatten]] Step step(const FreeBody& body, Rate rate, const CommutatorFree& method,
                           const Matrix3d& X, double h) {
  const Vector3d momentum = body_momentum(body, false, X);
  Stages s = zero_stages();
  s[0] = rate(momentum);
  for (int k = 1; k < method.stages; ++k) {
    Vector3d m = momentum;
    for (const TableauRow& row : method.stage[static_cast<std::size_t>(k)]) {
      m = turned_back(h * weighted_sum(row, s, k), m);
    }
    s[static_cast<std::size_t>(k)] = rate(m);
  }
  Matrix3d end = X;
  for (const TableauRow& row : method.update)
    end *= so3::Formulas::exp(h * weighted_sum(row, s, method.stages));
  return {end, 0.0, method.stages};
}

/// Solves m1 = exp(-h hat(w)) m0, w = I^-1 (m0 + m1)/2 to round-off by fixed-point iteration. The
/// energy is conserved, 2 (T1 - T0) = 2 (m1 - m0) . w = 0, because the rotation is about w. The
/// same holds with a wheel, where w = I^-1 ((m0 + m1)/2 - h). Energy loss adds its term to w.
template <class Rate>
[[gnu::flatten]] Step step(const FreeBody& body, Rate rate, const ImplicitTrapezoid& method,
                           const Matrix3d& X, double h) {
  constexpr int most_iterations = 100;
  Vector3d m0 = body_momentum(body, false, X);
  Matrix3d end = X;
  int evaluations = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(method.count); ++i) {
    const double part = method.fractions[i] * h;
    Vector3d m1 = m0, u = Vector3d::Zero();
    double change = infinite, before = infinite;
    for (int n = 0; n < most_iterations && change > 0.0; ++n) {
      u = part * rate(0.5 * (m0 + m1));
      const Vector3d next = turned_back(u, m0);
      before = change;
      change = (next - m1).norm();
      m1 = next;
      ++evaluations;
      if (change >= before && change <= 1e-14 * m0.norm()) break;  // Only round-off is left.
    }
    if (!(change <= 1e-14 * m0.norm())) return {X, infinite, evaluations};
    m0 = m1;
    end *= so3::Formulas::exp(u);
  }
  return {end, 0.0, evaluations};
}

/// Applies only the energy loss, m' = m x (a m x w), by the midpoint rule.
Vector3d lose_energy(const FreeBody& body, double h, Matrix3d& X, const Vector3d& m) {
  const auto slip = [&](const Vector3d& at) {
    return Vector3d(body.energy_loss() * at.cross(unchecked::rigid_velocity(body, at)));
  };
  const Vector3d u = h * slip(turned_back(0.5 * h * slip(m), m));
  X *= so3::Formulas::exp(u);
  return turned_back(u, m);
}

/// With a wheel the energy is the sum of (m_i - h_i)^2/(2 I_i), whose flows are also rotations.
/// With energy loss, the step begins and ends with half a step of the loss.
Step step(const FreeBody& body, const StrangSplitting&, const Matrix3d& X, double h) {
  constexpr std::array<std::pair<int, double>, 5> turns{
      {{0, 0.5}, {1, 0.5}, {2, 1.0}, {1, 0.5}, {0, 0.5}}};
  Vector3d m = body_momentum(body, false, X);
  Matrix3d end = X;
  const bool loses = body.energy_loss() > 0;
  if (loses) m = lose_energy(body, 0.5 * h, end, m);
  for (const auto& [axis, fraction] : turns) {
    const Vector3d a = body.principal().axes.col(axis);
    const double along = a.dot(m) - a.dot(body.interior().wheel);
    const Vector3d u = (fraction * h * along / body.principal().moments[axis]) * a;
    m = turned_back(u, m);
    end *= so3::Formulas::exp(u);
  }
  if (loses) lose_energy(body, 0.5 * h, end, m);
  return {end, 0.0, loses ? 9 : 5};
}

template <class Series>
Step step(Series series, const Vector3d& momentum, const Taylor& method, const Matrix3d& X,
          double h) {
  if constexpr (requires { series.expand(series.state_of(X, momentum), h); }) {
    series.expand(series.state_of(X, momentum), h);
  } else {
    series.expand(series.state_of(X, momentum));
  }
  return {series.sample(h, series.at(h)).X, series.last_terms(h), method.order};
}

Step step(const FreeBody& body, const Taylor& method, const Matrix3d& X, double h) {
  const Vector3d momentum = body_momentum(body, false, X);
  return body.is_rigid() ? step(TaylorSeries(body, method), momentum, method, X, h)
                         : step(InteriorSeries(body, method), momentum, method, X, h);
}

/// The motion is autonomous, so a step restarts it from the velocity at X.
Step step(const FreeBody& body, const ClosedForm&, const Matrix3d& X, double h) {
  const Vector3d w = unchecked::rigid_velocity(body, body_momentum(body, false, X));
  return {X * ExactSolution(body.with_start(w, Matrix3d::Identity())).at(h).X, 0.0, 1};
}

}  // namespace

namespace unchecked {

Vector3d angular_velocity(const FreeBody& body, const Method& method, const Matrix3d& X) {
  return unchecked::turning_rate(body, body_momentum(body, method.linear(), X));
}

Step take_step(const FreeBody& body, const Method& method, const Matrix3d& X, double h) {
  const auto take = [&](const auto& scheme) {
    // The kind of body is chosen once per step, because a choice in every stage costs 5 %.
    if constexpr (requires { step(body, RigidRate{body}, scheme, X, h); }) {
      return body.is_rigid() ? step(body, RigidRate{body}, scheme, X, h)
                             : step(body, InteriorRate{body}, scheme, X, h);
    } else {
      return step(body, scheme, X, h);
    }
  };
  return std::visit(take, method.scheme->kind);
}

}  // namespace unchecked

Vector3d angular_velocity(const FreeBody& body, const Method& method, const Matrix3d& X) {
  require_finite_entries("X", X);
  return unchecked::angular_velocity(body, method, X);
}

Step take_step(const FreeBody& body, const Method& method, const Matrix3d& X, double h) {
  require_finite_entries("X", X);
  require_finite("h", h);
  return unchecked::take_step(body, method, X, h);
}

}  // namespace twrench::motion
