#include "check/verdict/phase.h"

#include <twrench/motion/exact.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::check {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Tracks, from row to row, the time at which the exact motion has the same direction of the
/// momentum in the body as the row. The direction does not depend on the magnitude of the momentum.
class Delay {
 public:
  explicit Delay(const Reference& reference)
      : body_(reference.body), exact_(reference.body), start_(reference.start) {
    const auto flips = exact_.flips();
    const double turn = 1 / body_.omega().norm();
    longest_ = flips && std::isfinite(flips->interval) ? flips->interval / 8 : turn;
  }

  /// The rate at which the direction moves at t, 1/s.
  double speed(double t) const { return velocity(exact_.at(t - start_).omega).norm(); }

  /// Returns the delay in s at time t. If the direction moves slower than `slowest`, 1/s, it does
  /// not determine the delay, and that of the previous row is returned.
  double follow(double t, const Vector3d& omega, double slowest) {
    const Vector3d direction = (body_.inertia() * omega).normalized();
    double shift = 0;
    for (int i = 0; i < iterations; ++i) {
      const Vector3d there = exact_.at(t - start_ - delay_ - shift).omega;
      const Vector3d v = velocity(there);
      if (!(v.norm() > slowest)) return delay_;
      const Vector3d apart = (body_.inertia() * there).normalized() - direction;
      shift += std::clamp(apart.dot(v) / v.squaredNorm(), -longest_, longest_);
    }
    return delay_ += std::clamp(shift, -longest_, longest_);
  }

  /// The exact motion at t minus the delay, and at t.
  motion::Sample delayed(double t) const { return exact_.at(t - start_ - delay_); }
  motion::Sample exact(double t) const { return exact_.at(t - start_); }

 private:
  static constexpr int iterations = 6;

  /// The derivative of the unit vector of m = I omega, by Euler's equations m' = m x omega.
  Vector3d velocity(const Vector3d& omega) const {
    return (body_.inertia() * omega).normalized().cross(omega);
  }

  const motion::FreeBody& body_;
  motion::ExactMotion exact_;
  double start_;
  double longest_ = 0;
  double delay_ = 0;
};

/// How far R turns about the unit vector n, and how far it turns n itself, rad.
struct Twist {
  double about, across;
};

Twist twist(const Matrix3d& R, const Vector3d& n) {
  const Eigen::Quaterniond q(R);
  const double about = 2 * std::atan2(q.vec().dot(n), q.w());
  const Vector3d turned = R * n;
  return {std::remainder(about, 2 * std::numbers::pi),
          std::atan2(n.cross(turned).norm(), n.dot(turned))};
}

/// Updates the parts with the last row of a span, by the exact motion at its time and at the time
/// minus the delay.
void add_row(ErrorParts& parts, const Reference& reference, const Delay& delay,
             const recording::Row& row, bool has_attitude) {
  const motion::Sample exact = delay.exact(row.t), delayed = delay.delayed(row.t);
  const auto largest = [](double& most, const Vector3d& difference) {
    most = std::max(most, difference.cwiseAbs().maxCoeff());
  };
  largest(parts.phase_rate, delayed.omega - exact.omega);
  largest(parts.amplitude_rate, row.omega - delayed.omega);
  if (!has_attitude) return;
  const Vector3d L = (reference.frame * reference.body.momentum()).normalized();
  const Twist left = twist(row.X * (reference.frame * delayed.X).transpose(), L);
  if (std::abs(left.about) > std::abs(parts.angle_about_l)) parts.angle_about_l = left.about;
  parts.tilt = std::max(parts.tilt, left.across);
}

}  // namespace

std::optional<ErrorParts> error_parts(const Reference& reference, std::span<const Span> spans,
                                      bool has_attitude) {
  if (reference.body.omega().norm() == 0) return std::nullopt;
  Delay delay(reference);
  double fastest = 0;
  for (const Span& span : spans) fastest = std::max(fastest, delay.speed(span.last.t));
  constexpr double steady = 1e-9, tells = 0.05;
  if (fastest <= steady * reference.body.omega().norm()) return std::nullopt;
  ErrorParts parts;
  for (const Span& span : spans) {
    const double late = delay.follow(span.last.t, span.last.omega, tells * fastest);
    if (std::abs(late) > std::abs(parts.delay)) {
      parts.delay = late;
      parts.delay_at = span.last.t;
    }
    parts.delay_at_end = late;
    add_row(parts, reference, delay, span.last, has_attitude);
  }
  return parts;
}

}  // namespace twrench::check
