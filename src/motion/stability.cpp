#include <twrench/motion/stability.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/require.h"
#include "body/moments.h"

namespace twrench::motion {

using body::PrincipalAxes;
using Eigen::Vector3d;

double Stability::doubling_time() const { return std::numbers::ln2 / rate; }
double Stability::period() const { return 2 * std::numbers::pi / rate; }

Stability stability(const Vector3d& moments, PrincipalAxes::Axis axis, double omega) {
  body::require_ascending_moments(moments);
  if (std::ranges::find(PrincipalAxes::all, axis) == PrincipalAxes::all.end()) {
    throw InvalidArgument("axis", "must be the axis of least, intermediate or greatest moment");
  }
  require_finite("omega", omega);
  const double I = moments[axis], J = moments[(axis + 1) % 3], K = moments[(axis + 2) % 3];
  const double square = (I - J) / J * ((I - K) / K);  // of a wobble's frequency over omega
  const double rate = std::abs(omega) * std::sqrt(std::abs(square));
  const auto is_equal = [&](double other) {
    return body::are_equal_moments(std::min(I, other), std::max(I, other));
  };
  if (is_equal(J) || is_equal(K) || !(rate > 0)) return {};
  return {square < 0 ? Stability::Kind::unstable : Stability::Kind::stable, rate};
}

double stabilizing_wheel(const Vector3d& moments, double omega) {
  body::require_ascending_moments(moments);
  require_finite("omega", omega);
  return (moments[2] - moments[1]) * omega;
}

Tilt::Tilt(const FreeBody& body)
    : moments_(body.principal().moments),
      axes_(body.principal().axes),
      momentum_from_omega_(body.principal().axes.transpose() * body.inertia()),
      start_(momentum_from_omega_ * body.omega()),
      is_rigid_(body.is_rigid()),
      momentum_(body.momentum()) {
  const Vector3d wheel = axes_.transpose() * body.interior().wheel;
  if (!is_rigid_) start_ += wheel;
  std::size_t nearest = 0;
  start_.cwiseAbs().maxCoeff(&nearest);
  axis_ = PrincipalAxes::all[nearest];
  const double along = std::copysign(start_.stableNorm(), start_[axis_]);
  steady_rate_ = std::abs(along - wheel[axis_]) / moments_[axis_];
}

Vector3d Tilt::momentum(const Sample& sample) const {
  require_finite_entries("omega", sample.omega);
  if (is_rigid_) return momentum_from_omega_ * sample.omega;
  require_finite_entries("X", sample.X);
  return axes_.transpose() * (sample.X.transpose() * momentum_);
}

double Tilt::of(const Sample& sample) const {
  const Vector3d m = momentum(sample);
  const double across = std::hypot(m[(axis_ + 1) % 3], m[(axis_ + 2) % 3]);
  return std::atan2(across, std::abs(m[axis_]));
}

double Tilt::from_start(const Sample& sample) const {
  const double acute = of(sample);
  const bool is_over = momentum(sample)[axis_] * start_[axis_] < 0;
  return is_over ? std::numbers::pi - acute : acute;
}

Vector3d Tilt::direction(const Sample& sample) const {
  const Vector3d m = momentum(sample);
  const Vector3d nearer_end = std::copysign(1.0, m[axis_]) * Vector3d::Unit(axis_);
  return axes_ * m.cross(nearer_end).stableNormalized();
}

std::optional<Tilt::Growth> Tilt::growth() const {
  if (!is_rigid_) return std::nullopt;
  const auto [kind, rate] = stability(moments_, axis_, steady_rate_);
  if (kind != Stability::Kind::unstable) return std::nullopt;
  const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
  // m_i' = a m_j and m_j' = b m_i, with a b = rate^2. The growing part of (m_i, m_j) is along (a,
  // rate).
  const double spin = std::copysign(start_.stableNorm(), start_[axis_]);
  const double a = spin * (1 / moments_[axis_] - 1 / moments_[j]);
  const double grown_i = (start_[i] + a / rate * start_[j]) / 2;
  const double grown_j = rate / a * grown_i;
  return Growth{std::hypot(grown_i, grown_j) / start_.stableNorm(), rate};
}

}  // namespace twrench::motion
