#include "interchange/played_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace

PlayedMotion::PlayedMotion(const motion::FreeBody& body, double speed)
    : exact_(body),
      speed_(speed),
      principal_from_body_(body.principal().axes.transpose()),
      coupling_(coupling(body.principal().moments)) {
  const double momentum = body.momentum().stableNorm();
  const double twice_energy = body.omega().dot(body.momentum());
  least_rate_ = momentum > 0 ? twice_energy / momentum : 0;
  const Vector3d c = coupling_.cwiseAbs();
  const Vector3d w =
      component_bounds(body.principal().moments.array(), principal_from_body_ * body.omega());
  const Vector3d d1 = products(c, w, w);
  const Vector3d d2 = products(c, d1, w) + products(c, w, d1);
  const Vector3d d3 = products(c, d2, w) + 2 * products(c, d1, d1) + products(c, w, d2);
  const Vector3d d4 =
      products(c, d3, w) + 3 * products(c, d2, d1) + 3 * products(c, d1, d2) + products(c, w, d3);
  curvatures_ = {d2.norm(), d3.norm(), d4.norm()};
}

/// Between two samples, the length of a vector function exceeds that of the longer one by at most
/// gap^2/8 times the bound of its second derivative.
PlayedMotion::Peaks PlayedMotion::peaks(double begin, double end) const {
  constexpr int gaps = 8;
  Peaks peaks;
  for (int i = 0; i <= gaps; ++i) {
    const Vector3d w = principal_from_body_ * at(begin + (end - begin) * i / gaps).omega;
    const Vector3d d1 = products(coupling_, w, w);
    const Vector3d d2 = products(coupling_, d1, w) + products(coupling_, w, d1);
    peaks.velocity = std::max(peaks.velocity, w.norm());
    peaks.acceleration = std::max(peaks.acceleration, d1.norm());
    peaks.jerk = std::max(peaks.jerk, d2.norm());
  }
  const double gap = speed_ * (end - begin) / gaps, bend = gap * gap / 8;
  return {peaks.velocity + bend * curvatures_.velocity,
          peaks.acceleration + bend * curvatures_.acceleration,
          peaks.jerk + bend * curvatures_.jerk};
}

/// On SO(3) with its bi-invariant metric the covariant acceleration is omega' in body axes.
RateBounds PlayedMotion::attitude_rates(double begin, double end) const {
  const Peaks p = peaks(begin, end);
  return {speed_ * p.velocity, speed_ * speed_ * p.acceleration};
}

/// In space v = X omega has v' = X omega' and v'' = X (omega'' + omega x omega'). With the
/// direction u = v/|v|, the tangential part of u'' and |v|''/|v| are both at most |v''|/|v| +
/// (|v'|/|v|)^2.
RateBounds PlayedMotion::omega_rates(double begin, double end) const {
  if (!(least_rate_ > 0)) return {};
  const Peaks p = peaks(begin, end);
  const double turning = p.acceleration / least_rate_;
  const double bending = (p.jerk + p.velocity * p.acceleration) / least_rate_;
  return {speed_ * turning, speed_ * speed_ * (bending + turning * turning)};
}

}  // namespace twrench::interchange
