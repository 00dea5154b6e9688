#include "motion/taylor.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace twrench::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// 1/k.
constexpr auto reciprocal = [] {
  std::array<double, max_taylor_order + 1> table{};
  for (std::size_t k = 1; k < table.size(); ++k) table[k] = 1.0 / static_cast<double>(k);
  return table;
}();

/// Returns the rotation of the quaternion (w, v) with the given squared norm.
Matrix3d rotation(double w, const Vector3d& v, double squared_norm) {
  const Vector3d u = (2 / squared_norm) * v;
  const double xx = u.x() * v.x(), yy = u.y() * v.y(), zz = u.z() * v.z();
  const double xy = u.x() * v.y(), yz = u.y() * v.z(), zx = u.z() * v.x();
  const double wx = w * u.x(), wy = w * u.y(), wz = w * u.z();
  Matrix3d R;
  R << 1 - (yy + zz), xy - wz, zx + wy,  //
      xy + wz, 1 - (zz + xx), yz - wx,   //
      zx - wy, yz + wx, 1 - (xx + yy);
  return R;
}

}  // namespace

TaylorSeries::TaylorSeries(const FreeBody& body, const Taylor& method)
    : order_(checked_order(method)), axes_(body.principal().axes) {
  const Vector3d& I = body.principal().moments;
  const double G = body.momentum().stableNorm();
  unit_ = G > 0 ? I[0] / G : 1.0;
  velocity_ = I[0] * I.cwiseInverse();
  excess_ = (I.array() - I[1]) / I.array();
  const Vector3d mu = (unit_ / I[0]) * I.cwiseProduct(axes_.transpose() * body.omega());
  energy_ = excess_.dot(mu.cwiseAbs2());
}

TaylorSeries::State TaylorSeries::state_of(const Matrix3d& X, const Vector3d& momentum) const {
  return {X * axes_, (axes_.transpose() * momentum).stableNormalized()};
}

Sample TaylorSeries::sample(double t, const State& state) const {
  return {t, state.X * axes_.transpose(), axes_ * (velocity_ / unit_).cwiseProduct(state.mu)};
}

/// Once the coefficients of order k are known, their products are added to the sums of all later
/// orders. These additions are independent of each other, unlike those within a single sum.
void TaylorSeries::expand(const State& state) {
  start_ = state;
  const Vector3d &n = state.mu, &w = velocity_, wn = w.cwiseProduct(n);
  const Pair euler12{w[2] - w[1], w[0] - w[2]};
  const double euler3 = w[1] - w[0];
  const Pair n12{n[0], n[1]}, n23{n[1], n[2]};
  // Coefficients of order k: (m1, m2), (m2, m3), (m3, d) and (m1, f), where d and f belong to 1 +
  // mu . n and psi'. Their products in pairs are (m1 m2, m2 m3) and (m3 m1, d f).
  std::array<Pair, capacity> m23, m3d, m1f;
  // Initialised by the first product that is added.
  std::array<Pair, 2 * capacity> sum12_23, sum31_df;
  sum12_23[1] = sum31_df[1] = Pair{};
  m12_[0] = n12;
  m3psi_[0] = Pair{n[2], 0};
  double f = wn.dot(n);
  const double f0 = f;
  double products12 = n[0] * n[1], products23 = n[1] * n[2], products31 = n[2] * n[0];
  for (std::size_t k = 1;; ++k) {
    const Pair a = (reciprocal[k] * euler12) * Pair{products23, products31};
    const double m1 = a[0], m2 = a[1], m3 = (reciprocal[k] * euler3) * products12;
    m12_[k] = a;
    m3psi_[k] = Pair{m3, reciprocal[k] * f};
    if (k == order_) return;
    const double d = n[0] * m1 + n[1] * m2 + n[2] * m3;
    const double numerator = wn[0] * m1 + wn[1] * m2 + wn[2] * m3;
    f = 0.5 * (numerator - sum31_df[k][1] - d * f0);
    const Pair b{m2, m3}, c{m3, d}, e{m1, f};
    const Pair next = sum12_23[k] + n12 * b + a * n23;
    products12 = next[0];
    products23 = next[1];
    products31 = sum31_df[k][0] + n[2] * m1 + m3 * n[0];
    m23[k] = b, m3d[k] = c, m1f[k] = e;
    const std::size_t last = std::min(k - 1, order_ - k);
    for (std::size_t j = 1; j <= last; ++j) {
      sum12_23[k + j] += m12_[j] * b + a * m23[j];
      sum31_df[k + j] += m3d[j] * e + c * m1f[j];
    }
    sum12_23[2 * k] = a * b;
    sum31_df[2 * k] = c * e;
    sum12_23[2 * k + 1] = sum31_df[2 * k + 1] = Pair{};
  }
}

/// One step of Newton's method along the gradient squares the error. After any step whose last term
/// is below 1e-8, this leaves only round-off.
Vector3d TaylorSeries::with_initial_energy(const Vector3d& mu) const {
  const Vector3d gradient = 2 * excess_.cwiseProduct(mu);
  const double slope = gradient.squaredNorm();
  if (slope == 0) return mu.normalized();
  const double missing = energy_ * mu.squaredNorm() - excess_.dot(mu.cwiseAbs2());
  return (mu + (missing / slope) * gradient).normalized();
}

TaylorSeries::State TaylorSeries::at(double h) const {
  const double s = h / unit_, s2 = s * s;
  // Horner's rule, separately for even and odd powers, which halves the chain of dependent
  // operations.
  Pair m12{}, m3psi{}, odd12{}, odd3psi{};
  for (std::size_t k = order_; k > 0; k -= 2) {
    m12 = m12 * s2 + m12_[k];
    m3psi = m3psi * s2 + m3psi_[k];
    odd12 = odd12 * s2 + m12_[k - 1];
    odd3psi = odd3psi * s2 + m3psi_[k - 1];
  }
  m12 = m12 * s2 + (odd12 * s + m12_[0]);
  m3psi = m3psi * s2 + (odd3psi * s + m3psi_[0]);
  const Vector3d &n = start_.mu, mu = with_initial_energy({m12[0], m12[1], m3psi[0]});
  // The product of the quaternions (cos(psi/2), sin(psi/2) n) and (1 + mu . n, mu x n).
  const double c = std::cos(0.5 * m3psi[1]), sine = std::sin(0.5 * m3psi[1]);
  const double a = 1 + mu.dot(n);
  const Vector3d v = mu.cross(n);
  return {start_.X * rotation(c * a, c * v + sine * (a * n + n.cross(v)), 2 * a), mu};
}

double TaylorSeries::term(std::size_t k) const {
  const Pair squares = m12_[k] * m12_[k] + m3psi_[k] * m3psi_[k];
  return std::sqrt(2 * (squares[0] + squares[1]));
}

LastTerms TaylorSeries::last() const { return {order_, term(order_ - 1), term(order_)}; }

}  // namespace twrench::motion
