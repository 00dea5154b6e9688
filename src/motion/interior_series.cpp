#include "motion/interior_series.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "math/unaligned.h"
#include "motion/unchecked_rate.h"

namespace twrench::motion {

using Eigen::Matrix3d;
using Eigen::Vector3d;

InteriorSeries::InteriorSeries(const FreeBody& body, const Taylor& method)
    : body_(body), order_(checked_order(method)) {
  const double G = body.momentum().stableNorm(), fastest = body.fastest_rate();
  if (fastest > 0) time_unit_ = 1 / fastest;
  if (G > 0) momentum_unit_ = G;
  loss_ = body.energy_loss() * momentum_unit_;
  inverse_ = body.inverse() * (momentum_unit_ * time_unit_);
}

InteriorSeries::State InteriorSeries::state_of(const Matrix3d& X, const Vector3d&) const {
  return {X};
}

Sample InteriorSeries::sample(double t, const State& state) const {
  return {t, state.X, unchecked::turning_rate(body_, state.X.transpose() * body_.momentum())};
}

void InteriorSeries::expand(const State& state) {
  start_ = state;
  std::array<Vector3d, max_taylor_order + 1> m, w, c, omega;
  m[0] = state.X.transpose() * body_.momentum() / momentum_unit_;
  w[0] = inverse_ * (m[0] - body_.interior().wheel / momentum_unit_);
  q_[0] = {1, Vector3d::Zero()};
  for (std::size_t k = 0;; ++k) {
    if (k > 0) w[k] = inverse_ * m[k];
    c[k] = Vector3d::Zero();
    for (std::size_t j = 0; j <= k; ++j) c[k] += m[j].cross(w[k - j]);
    omega[k] = w[k] + loss_ * c[k];
    Vector3d change = c[k], turn = Vector3d::Zero();
    double scalar = 0;
    for (std::size_t j = 0; j <= k; ++j) {
      change += loss_ * m[j].cross(c[k - j]);
      turn += q_[j].w * omega[k - j] + q_[j].v.cross(omega[k - j]);
      scalar -= q_[j].v.dot(omega[k - j]);
    }
    const double next = static_cast<double>(k) + 1;
    q_[k + 1] = {0.5 * scalar / next, 0.5 / next * turn};
    if (k + 1 == order_) break;
    m[k + 1] = change / next;
  }
  // |dX| = 2 sqrt(2) |dq| for a unit quaternion.
  const auto term = [&](std::size_t k) {
    return 2 * std::numbers::sqrt2 * std::hypot(q_[k].w, q_[k].v.stableNorm());
  };
  last_ = {order_, term(order_ - 1), term(order_)};
}

InteriorSeries::State InteriorSeries::at(double h) const {
  const double s = h / time_unit_;
  Quaternion q = q_[order_];
  for (std::size_t k = order_; k > 0; --k) {
    q.w = q.w * s + q_[k - 1].w;
    q.v = q.v * s + q_[k - 1].v;
  }
  const so3::Quaternion turn(q.w, q.v.x(), q.v.y(), q.v.z());
  return {start_.X * turn.normalized().toRotationMatrix()};
}

}  // namespace twrench::motion
