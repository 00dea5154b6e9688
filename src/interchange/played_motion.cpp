#include "interchange/played_motion.h"

#include <twrench/motion/error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace twrench::interchange {
namespace {

using Eigen::Vector3d;

/// The right-hand side of Euler's equations in principal axes, as a bilinear form.
Vector3d products(const Vector3d& c, const Vector3d& a, const Vector3d& b) {
  return {c.x() * a.y() * b.z(), c.y() * a.z() * b.x(), c.z() * a.x() * b.y()};
}

Vector3d coupling(const Vector3d& moments) {
  return {(moments.y() - moments.z()) / moments.x(), (moments.z() - moments.x()) / moments.y(),
          (moments.x() - moments.y()) / moments.z()};
}

/// Returns bounds for the magnitudes of omega's components in principal axes at any time, given
/// those at one time. With the energy T and the momentum L, the sum of I_i (I_i - J) omega_i^2 =
/// L^2 - 2 T J is constant for every J. It bounds the components if its terms have one sign only:
/// for J = 0, and for the least and the greatest moment. The sum of I_i omega_i^2 is constant too.
Vector3d component_bounds(const Eigen::Array3d& moments, const Vector3d& omega) {
  const Eigen::Array3d squares = omega.array().square();
  Eigen::Array3d bounds = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  for (const Eigen::Array3d& weights : {moments, Eigen::Array3d(moments.square()),
                                        Eigen::Array3d(moments * (moments - moments.minCoeff())),
                                        Eigen::Array3d(moments * (moments.maxCoeff() - moments))}) {
    const double sum = (weights * squares).sum();
    bounds = (weights > 0).select(bounds.min(sum / weights), bounds);
  }
  return bounds.sqrt().matrix();
}

/// Returns the derivative of a product by Leibniz' rule. `term(i, k)` is the product of the first
/// factor's derivative of order i and the second's of order k.
template <typename Term>
auto leibniz(std::size_t order, const Term& term) {
  auto sum = term(0, order);
  double binomial = 1;
  for (std::size_t i = 1; i <= order; ++i) {
    binomial = binomial * static_cast<double>(order - i + 1) / static_cast<double>(i);
    sum += binomial * term(i, order - i);
  }
  return sum;
}

/// omega in body axes and its first two derivatives.
struct Derivatives {
  Vector3d omega, first, second;
};

/// Differentiates omega = w + a (m x w) with w = I^-1 (m - h) and m' = m x omega.
Derivatives derivatives(const motion::FreeBody& body, const motion::Sample& sample) {
  const double a = body.energy_loss();
  const Vector3d m0 = sample.X.transpose() * body.momentum(), w0 = body.rigid_velocity(m0);
  const Vector3d omega = sample.omega;
  const Vector3d m1 = m0.cross(omega), w1 = body.inverse() * m1;
  const Vector3d first = w1 + a * (m1.cross(w0) + m0.cross(w1));
  const Vector3d m2 = m1.cross(omega) + m0.cross(first), w2 = body.inverse() * m2;
  return {omega, first, w2 + a * (m2.cross(w0) + 2 * m1.cross(w1) + m0.cross(w2))};
}

/// Returns a lower bound for |omega| in rad/s at all times; 0 if there is none. Without a wheel
/// omega . L = 2 T, which is at least |L|^2/I3.
double least_rate(const motion::FreeBody& body) {
  const double momentum = body.momentum().stableNorm();
  if (momentum == 0 || !body.interior().wheel.isZero(0)) return 0;
  if (body.energy_loss() > 0) return momentum / body.principal().moments[2];
  return body.omega().dot(body.momentum()) / momentum;
}

}  // namespace

PlayedMotion::PlayedMotion(const motion::FreeBody& body, double speed, double end,
                           const std::atomic<bool>* stop,
                           std::shared_ptr<const scene::ShownRecording> recording)
    : body_(body),
      motion_(body, speed * end, stop),
      speed_(speed),
      recording_(std::move(recording)),
      stop_(stop),
      least_rate_(least_rate(body)) {
  curvatures_ = body.is_rigid() ? curvatures_of_rigid_body() : curvatures_with_interior();
}

motion::Sample PlayedMotion::at(double time) const {
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
    throw motion::MotionError("export", "was stopped", motion::MotionError::Reason::stopped);
  }
  return recording_ ? recording_->motion.at(speed_ * time) : motion_.at(speed_ * time);
}

PlayedMotion::Peaks PlayedMotion::curvatures_of_rigid_body() const {
  const body::PrincipalAxes& principal = body_.principal();
  const Vector3d c = coupling(principal.moments).cwiseAbs();
  std::array<Vector3d, 5> d;
  d[0] = component_bounds(principal.moments.array(), principal.axes.transpose() * body_.omega());
  for (std::size_t k = 0; k + 1 < d.size(); ++k) {
    d[k + 1] = leibniz(k, [&](std::size_t i, std::size_t j) { return products(c, d[i], d[j]); });
  }
  return {d[2].norm(), d[3].norm(), d[4].norm()};
}

/// Bounds the derivatives of m, w and omega in turn, from |m| = |L|.
PlayedMotion::Peaks PlayedMotion::curvatures_with_interior() const {
  constexpr std::size_t most = 4;
  std::array<double, most + 1> m{}, w{}, omega{};
  const auto product = [](const auto& p, const auto& q, std::size_t order) {
    return leibniz(order, [&](std::size_t i, std::size_t k) { return p[i] * q[k]; });
  };
  const double least_moment = body_.principal().moments[0];
  m[0] = body_.momentum().stableNorm();
  w[0] = (m[0] + body_.interior().wheel.stableNorm()) / least_moment;
  for (std::size_t k = 0;; ++k) {
    omega[k] = w[k] + body_.energy_loss() * product(m, w, k);
    if (k == most) break;
    m[k + 1] = product(m, omega, k);
    w[k + 1] = m[k + 1] / least_moment;
  }
  return {omega[2], omega[3], omega[4]};
}

/// Between two samples, the length of a vector function exceeds that of the longer one by at most
/// gap^2/8 times the bound of its second derivative.
PlayedMotion::Peaks PlayedMotion::peaks(double begin, double end) const {
  constexpr int gaps = 8;
  Peaks peaks;
  double slowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= gaps; ++i) {
    const Derivatives d = derivatives(body_, at(begin + (end - begin) * i / gaps));
    slowest = std::min(slowest, d.omega.norm());
    peaks.velocity = std::max(peaks.velocity, d.omega.norm());
    peaks.acceleration = std::max(peaks.acceleration, d.first.norm());
    peaks.jerk = std::max(peaks.jerk, d.second.norm());
  }
  const double gap = speed_ * (end - begin) / gaps, bend = gap * gap / 8;
  peaks.velocity += bend * curvatures_.velocity;
  peaks.acceleration += bend * curvatures_.acceleration;
  peaks.jerk += bend * curvatures_.jerk;
  peaks.least_velocity = std::max(least_rate_, slowest - 0.5 * gap * peaks.acceleration);
  return peaks;
}

/// On SO(3) with its bi-invariant metric the covariant acceleration is omega' in body axes.
RateBounds PlayedMotion::attitude_rates(double begin, double end) const {
  if (recording_) {
    const auto [velocity, acceleration] =
        recording_->motion.rates_between(speed_ * begin, speed_ * end);
    return {speed_ * velocity, speed_ * speed_ * acceleration};
  }
  const Peaks p = peaks(begin, end);
  return {speed_ * p.velocity, speed_ * speed_ * p.acceleration};
}

/// In space v = X omega has v' = X omega' and v'' = X (omega'' + omega x omega'). With the
/// direction u = v/|v|, the tangential part of u'' and |v|''/|v| are both at most |v''|/|v| +
/// (|v'|/|v|)^2.
RateBounds PlayedMotion::omega_rates(double begin, double end) const {
  const Peaks p = peaks(begin, end);
  if (p.velocity == 0) return {};
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (!(p.least_velocity > 0)) return {unknown, unknown};
  const double turning = p.acceleration / p.least_velocity;
  const double bending = (p.jerk + p.velocity * p.acceleration) / p.least_velocity;
  return {speed_ * turning, speed_ * speed_ * (bending + turning * turning)};
}

}  // namespace twrench::interchange
