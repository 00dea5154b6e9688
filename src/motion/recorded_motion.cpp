#include "motion/recorded_motion.h"

#include <twrench/base/error.h>
#include <twrench/math/so3.h>

#include <algorithm>
#include <limits>
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
RecordedMotion::Piece RecordedMotion::piece_between(std::size_t begin, std::size_t end) const {
  const Instant &first = instants_[begin], &last = instants_[end];
  const double length = last.t - first.t;
  const Eigen::Matrix3d start = Eigen::Quaterniond(first.X).toRotationMatrix();
  const Vector3d turn = so3::log(start.transpose() * Eigen::Quaterniond(last.X));
  const Vector3d rate0 = length * first.omega;
  const Vector3d rate1 = length * so3::dexpinv(so3::angle_functions(turn), turn, last.omega);
  return {start, first.t, rate0, 3 * turn - 2 * rate0 - rate1, rate0 + rate1 - 2 * turn, length};
}

Sample RecordedMotion::at(double t) const {
  if (t <= 0) return sample_of(t, instants_.front());
  if (t >= duration()) return sample_of(t, instants_.back());
  const std::size_t i = before(t);
  if (t == instants_[i].t || is_gap_after(i)) return sample_of(t, instants_[i]);
  return piece_between(i, i + 1).at(t);
}

Sample RecordedMotion::Piece::at(double t) const {
  const double s = (t - begin) / length;
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
    const Piece piece = piece_between(i, i + 1);
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

bool RecordedMotion::can_skip(std::size_t begin, std::size_t end, double angle) const {
  const Piece piece = piece_between(begin, end);
  for (std::size_t i = begin + 1; i < end; ++i) {
    const Eigen::Matrix3d X = Eigen::Quaterniond(instants_[i].X).toRotationMatrix();
    if (so3::log(X.transpose() * piece.at(instants_[i].t).X).norm() > angle) return false;
  }
  return true;
}

/// Doubles the number of skipped instants until the attitudes between deviate, then halves the
/// interval in which the number lies.
std::size_t RecordedMotion::farthest(std::size_t begin, std::size_t limit, double angle) const {
  std::size_t near = begin + 1, far = std::min(begin + 2, limit);
  while (near < far && can_skip(begin, far, angle)) {
    near = far;
    far = std::min(begin + 2 * (far - begin), limit);
  }
  while (near + 1 < far) {
    const std::size_t middle = near + (far - near) / 2;
    (can_skip(begin, middle, angle) ? near : far) = middle;
  }
  return near;
}

/// Two instants of the result are closer than the ends of any gap, so that gaps remain gaps.
RecordedMotion RecordedMotion::thinned(double angle) const {
  double shortest_gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < instants_.size(); ++i) {
    if (is_gap_after(i)) shortest_gap = std::min(shortest_gap, instants_[i + 1].t - instants_[i].t);
  }
  const std::size_t last = instants_.size() - 1;
  std::vector<Instant> kept{instants_.front()};
  double longest_step = 0;
  for (std::size_t i = 0, limit = 0; i < last;) {
    limit = std::max(limit, i + 1);
    while (limit < last && !is_gap_after(i) && !is_gap_after(limit) &&
           instants_[limit + 1].t - instants_[i].t < shortest_gap) {
      ++limit;
    }
    const std::size_t next = farthest(i, limit, angle);
    if (!is_gap_after(i)) {
      longest_step = std::max(longest_step, instants_[next].t - instants_[i].t);
    }
    kept.push_back(instants_[next]);
    i = next;
  }
  return {std::move(kept), longest_step};
}

std::vector<Sample> RecordedMotion::samples_at(std::span<const double> times) const {
  std::vector<Sample> samples;
  samples.reserve(times.size());
  for (const double t : times) samples.push_back(at(t));
  return samples;
}

}  // namespace twrench::motion
