#include "check/verdict/flips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace twrench::check {
namespace {

using Eigen::Vector3d;

/// The largest component along `axis` over one full swing; on the separatrix, over ten turns from
/// t = 0 on.
double amplitude(const motion::ExactMotion& exact, const Vector3d& axis, double speed) {
  const auto flips = exact.flips();
  const double turns = 10 * 2 * std::numbers::pi / speed;
  const double span = flips && std::isfinite(flips->interval) ? 2 * flips->interval : turns;
  constexpr int pieces = 256;
  double largest = 0;
  for (int i = 0; i <= pieces; ++i) {
    largest = std::max(largest, std::abs(axis.dot(exact.at(span * i / pieces).omega)));
  }
  return largest;
}

bool has_intermediate_axis(const Vector3d& moments) {
  constexpr double distinct = 1e-12;
  return moments[1] - moments[0] > distinct * moments[1] &&
         moments[2] - moments[1] > distinct * moments[1];
}

}  // namespace

FlipFinder::FlipFinder(const Reference& reference)
    : inertia_(reference.body.inertia()),
      axis_(reference.body.principal().axes.col(1)),
      has_axis_(has_intermediate_axis(reference.body.principal().moments)) {
  const double speed = reference.body.omega().norm();
  constexpr double beyond_noise = 0.05;
  if (has_axis_ && speed > 0) {
    threshold_ = beyond_noise * amplitude(motion::ExactMotion(reference.body), axis_, speed);
  }
}

void FlipFinder::keep(const SignChange& change) {
  if (found_.size() < most) found_.push_back(change);
}

/// The time, between that of the last row and t, at which the component crosses zero; `component`
/// is its value at t.
double FlipFinder::crossing(double t, double component) const {
  const double step = t - last_t_;
  const motion::ExactMotion from_last({inertia_, last_omega_});
  if (const auto flips = from_last.flips(); flips && flips->first <= step) {
    return last_t_ + flips->first;
  }
  const double before = axis_.dot(last_omega_);
  return last_t_ + step * before / (before - component);
}

void FlipFinder::add(double t, const Vector3d& omega) {
  if (!has_axis_) return;
  const double component = axis_.dot(omega), before = axis_.dot(last_omega_);
  if (side_ == 0 && component != 0) side_ = std::copysign(1.0, component);
  if (!at_ && component * side_ < 0) at_ = before * side_ > 0 ? crossing(t, component) : last_t_;
  if (std::abs(component) > threshold_) {
    if (component * side_ < 0) keep({*at_, component > 0});
    side_ = std::copysign(1.0, component);
    at_.reset();
  }
  last_t_ = t;
  last_omega_ = omega;
}

std::vector<SignChange> FlipFinder::finish() {
  if (at_ && axis_.dot(last_omega_) * side_ < 0) keep({*at_, side_ < 0});
  at_.reset();
  return found_;
}

std::vector<SignChange> exact_flips(const Reference& reference, double from, double to) {
  const motion::ExactMotion exact(reference.body);
  const auto flips = exact.flips();
  std::vector<SignChange> changes;
  if (!flips || !has_intermediate_axis(reference.body.principal().moments)) return changes;
  const bool repeats = std::isfinite(flips->interval);
  // On the separatrix there is one flip, before t = 0 or after it.
  const Vector3d axis = reference.body.principal().axes.col(1);
  if (!std::isfinite(flips->first)) return changes;
  const double first = reference.start + flips->first;
  const double after = repeats ? flips->interval / 2 : 1 / reference.body.omega().norm();
  const bool first_is_up = axis.dot(exact.at(flips->first + after).omega) > 0;
  double n = repeats ? std::floor((from - first) / flips->interval) + 1 : 0;
  for (double last = -INFINITY; changes.size() < FlipFinder::most; ++n) {
    const double t = n == 0 ? first : first + n * flips->interval;
    // A time may be so large that doubles near it are farther apart than the flips.
    if (t > to || t == last) break;
    last = t;
    if (t > from) changes.push_back({t, first_is_up == (std::fmod(n, 2) == 0)});
    if (!repeats) break;
  }
  return changes;
}

std::vector<Flip> paired(const std::vector<SignChange>& found,
                         const std::vector<SignChange>& exact) {
  std::vector<Flip> flips;
  std::size_t next = 0;
  for (const SignChange& change : found) {
    if (next < exact.size() && exact[next].up != change.up) flips.push_back({{}, exact[next++].t});
    Flip flip{change.t, {}};
    if (next < exact.size()) flip.exact = exact[next++].t;
    flips.push_back(flip);
  }
  for (; next < exact.size(); ++next) flips.push_back({{}, exact[next].t});
  return flips;
}

}  // namespace twrench::check
