#include "motion/recorded_motion.h"

#include <twrench/base/error.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <utility>

namespace twrench::motion {
namespace {

using Eigen::Vector3d;

/// Returns the angular velocity of X_0 exp(hat(u)) in body axes: the inverse of so3::dexpinv. The
/// difference loses digits of the last coefficient only where the term itself is small.
Vector3d dexp(const so3::AngleFunctions& f, const Vector3d& u, const Vector3d& rate) {
  const double square = u.squaredNorm();
  const double last = square > 0 ? (1 - f.a) / square : 1.0 / 6;
  return rate - f.b * u.cross(rate) + last * u.cross(u.cross(rate));
}

Sample sample_of(double t, const RecordedMotion::Instant& instant) {
  return {t, Eigen::Quaterniond(instant.X).toRotationMatrix(), instant.omega};
}

}  // namespace

RecordedMotion::RecordedMotion(std::vector<Instant> instants, double longest_step)
    : instants_(std::move(instants)), longest_step_(longest_step) {
  if (instants_.size() < 2) {
    throw InvalidArgument("instants", "fewer than two, which are no motion");
  }
  const double start = instants_.front().t;
  for (Instant& instant : instants_) instant.t -= start;
}

std::size_t RecordedMotion::before(double t) const {
  const auto later =
      std::ranges::upper_bound(instants_.begin() + 1, instants_.end() - 1, t, {}, &Instant::t);
  return static_cast<std::size_t>(later - instants_.begin()) - 1;
}

bool RecordedMotion::is_gap_after(std::size_t instant) const {
  return instants_[instant + 1].t - instants_[instant].t > longest_step_;
}

bool RecordedMotion::has_gaps() const {
  for (std::size_t i = 0; i + 1 < instants_.size(); ++i) {
    if (is_gap_after(i)) return true;
  }
  return false;
}

bool RecordedMotion::is_in_gap(double t) const {
  const std::size_t first = before(t);
  return is_gap_after(first) && t > instants_[first].t && t < instants_[first + 1].t;
}

/// Hermite's polynomial with u = 0 at the start.
RecordedMotion::Piece RecordedMotion::piece_after(std::size_t instant) const {
  const Instant &first = instants_[instant], &last = instants_[instant + 1];
  const double length = last.t - first.t;
  const Eigen::Matrix3d start = Eigen::Quaterniond(first.X).toRotationMatrix();
  const Vector3d end = so3::log(start.transpose() * Eigen::Quaterniond(last.X));
  const Vector3d rate0 = length * first.omega;
  const Vector3d rate1 = length * so3::dexpinv(so3::angle_functions(end), end, last.omega);
  return {start, rate0, 3 * end - 2 * rate0 - rate1, rate0 + rate1 - 2 * end, length};
}

Sample RecordedMotion::at(double t) const {
  if (t <= 0) return sample_of(t, instants_.front());
  if (t >= duration()) return sample_of(t, instants_.back());
  const std::size_t i = before(t);
  if (t == instants_[i].t || is_gap_after(i)) return sample_of(t, instants_[i]);
  const auto [start, linear, square, cube, length] = piece_after(i);
  const double s = (t - instants_[i].t) / length;
  const Vector3d u = s * (linear + s * (square + s * cube));
  const Vector3d rate = (linear + s * (2 * square + 3 * s * cube)) / length;
  return {t, start * so3::exp(u), dexp(so3::angle_functions(u), u, rate)};
}

/// With omega = dexp(u) u', |omega| is at most |u'|, and |omega'| at most |u''| + 0.6 |u| |u'|^2
/// for |u| <= pi: the derivative of dexp(u) is that of its coefficients, by their Taylor series,
/// and the product u' x (u x u') / 6.
RecordedMotion::Rates RecordedMotion::rates_between(double begin, double end) const {
  Rates most;
  for (std::size_t i = before(begin); i <= before(end); ++i) {
    if (is_gap_after(i)) continue;
    const Piece piece = piece_after(i);
    const double linear = piece.linear.norm(), square = piece.square.norm(),
                 cube = piece.cube.norm();
    const double u = linear + square + cube;
    const double rate = (linear + 2 * square + 3 * cube) / piece.length;
    const double bend = (2 * square + 6 * cube) / (piece.length * piece.length);
    most.velocity = std::max(most.velocity, rate);
    most.acceleration = std::max(most.acceleration, bend + 0.6 * u * rate * rate);
  }
  return most;
}

std::vector<Sample> RecordedMotion::samples_at(std::span<const double> times) const {
  std::vector<Sample> samples;
  samples.reserve(times.size());
  for (const double t : times) samples.push_back(at(t));
  return samples;
}

}  // namespace twrench::motion
