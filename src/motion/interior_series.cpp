#include "motion/interior_series.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/so3_formulas.h"
#include "motion/unchecked.h"

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

namespace {

/// Four numbers that the processor multiplies together. Their layout is independent of compiler
/// flags, as that of the types in math/unaligned.h.
using Four = Eigen::Array<double, 4, 1, Eigen::DontAlign>;

/// The components of a vector in the two orders that products multiply, with a fourth for the
/// product of quaternions.
struct Turned {
  Four yzx, zxy;
};

Turned turned(const Vector3d& v) {
  return {{v.y(), v.z(), v.x(), v.y()}, {v.z(), v.x(), v.y(), v.x()}};
}

/// The cross product, and a fourth number without meaning.
Four cross(const Turned& a, const Turned& b) { return a.yzx * b.zxy - a.zxy * b.yzx; }

/// A quaternion as the left factor of a product.
struct LeftFactor {
  Four w, yzx, zxy;

  LeftFactor() = default;
  LeftFactor(double scalar, const Vector3d& v)
      : w(scalar, scalar, scalar, -v.z()),
        yzx(v.y(), v.z(), v.x(), -v.x()),
        zxy(v.z(), v.x(), v.y(), v.y()) {}
};

/// The product of a quaternion and a vector: the components x, y, z and w.
Four product(const LeftFactor& q, const Four& xyzz, const Turned& v) {
  return q.w * xyzz + q.yzx * v.zxy - q.zxy * v.yzx;
}

}  // namespace

void InteriorSeries::expand(const State& state, double longest) {
  start_ = state;
  std::array<Turned, max_taylor_order + 1> m, w, omega;
  std::array<Four, max_taylor_order + 1> xyzz;  // of omega
  std::array<LeftFactor, max_taylor_order + 1> q;
  Vector3d momentum = state.X.transpose() * body_.momentum() / momentum_unit_;
  Vector3d rate = inverse_ * (momentum - body_.interior().wheel / momentum_unit_);
  q_[0] = {1, Vector3d::Zero()};
  const double reach = std::abs(longest) / time_unit_;
  double power = 1, before = 1;  // before: the contribution of the previous term
  for (std::size_t k = 0;; ++k) {
    m[k] = turned(momentum);
    w[k] = turned(rate);
    q[k] = {q_[k].w, q_[k].v};
    Four c = Four::Zero();
    for (std::size_t j = 0; j <= k; ++j) c += cross(m[j], w[k - j]);
    const Vector3d turning = rate + loss_ * c.head<3>().matrix();
    omega[k] = turned(turning);
    xyzz[k] = {turning.x(), turning.y(), turning.z(), turning.z()};
    Four change = Four::Zero(), turn = Four::Zero();
    for (std::size_t j = 0; j <= k; ++j) {
      change += cross(m[j], omega[k - j]);
      turn += product(q[j], xyzz[k - j], omega[k - j]);
    }
    const double next = static_cast<double>(k) + 1;
    q_[k + 1] = {0.5 / next * turn[3], 0.5 / next * turn.head<3>().matrix()};
    last_order_ = k + 1;
    power *= reach;
    const double contribution = power * (std::abs(q_[k + 1].w) + q_[k + 1].v.lpNorm<1>());
    if (last_order_ == order_ || std::max(before, contribution) < negligible) break;
    before = contribution;
    momentum = change.head<3>().matrix() / next;
    rate = inverse_ * momentum;
  }
}

LastTerms InteriorSeries::last() const {
  // |dX| = 2 sqrt(2) |dq| for a unit quaternion.
  const auto term = [&](std::size_t k) {
    return 2 * std::numbers::sqrt2 * std::hypot(q_[k].w, q_[k].v.stableNorm());
  };
  return {last_order_, term(last_order_ - 1), term(last_order_)};
}

InteriorSeries::State InteriorSeries::at(double h) const {
  const double s = h / time_unit_;
  Quaternion q = q_[last_order_];
  for (std::size_t k = last_order_; k > 0; --k) {
    q.w = q.w * s + q_[k - 1].w;
    q.v = q.v * s + q_[k - 1].v;
  }
  const so3::Quaternion turn(q.w, q.v.x(), q.v.y(), q.v.z());
  return {start_.X * turn.normalized().toRotationMatrix()};
}

}  // namespace twrench::motion
