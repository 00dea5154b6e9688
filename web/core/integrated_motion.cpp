#include "integrated_motion.h"

#include <twrench/base/error.h>
#include <twrench/motion/method.h>
#include <twrench/motion/propagator.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/require.h"
#include "body/moments.h"
#include "motion/energy_contours.h"
#include "motion/scheme.h"
#include "scene/limits.h"

namespace twrench::page {
namespace {

using Eigen::Vector3d;
using motion::EnergyContours;

const motion::Method& taylor() {
  static const motion::Method& method = motion::find_method("taylor");
  return method;
}

/// Returns the longest time in s: that of 100'000 rad at the greatest rate.
double longest_of(const motion::FreeBody& body) {
  constexpr double most_radians = 1e5, most_seconds = scene::limits::duration.high;
  const double rate = body.fastest_rate();
  return rate > 0 ? std::min(most_radians / rate, most_seconds) : most_seconds;
}

/// Returns the curve of constant energy through a direction of the momentum. Close to a saddle,
/// where the momentum rests for long, it is that of the separatrices that begin there.
EnergyContours::Curve path_from(const Vector3d& mu, const EnergyContours& contours) {
  EnergyContours::Curve path = contours.through(mu);
  if (path.size() > 1) return path;
  constexpr double near = 0.01;
  for (const EnergyContours::Curve& curve : contours.separatrices()) {
    if ((curve.front() - mu).norm() < near) path.insert(path.end(), curve.begin(), curve.end());
  }
  return path;
}

}  // namespace

IntegratedMotion::IntegratedMotion(const motion::FreeBody& body)
    : body_(body),
      longest_(longest_of(body)),
      series_(body_, std::get<motion::Taylor>(taylor().scheme->kind)),
      flips_(body_, taylor()),
      steps_{{0, series_.state_of(body_.attitude(), body_.body_momentum())}} {}

void IntegratedMotion::expand(std::size_t step) {
  if (expanded_ == step) return;
  series_.expand(steps_[step].state);
  expanded_ = step;
}

/// Takes the steps of the program's method `taylor`, so that the numbers are the same.
void IntegratedMotion::advance() {
  expand(steps_.size() - 1);
  const Step& step = steps_.back();
  const double end = step.t + series_.max_step(motion::min_tolerance), length = end - step.t;
  const Step next{end, series_.at(length)};
  flips_.visit({step.t, length, step.state.X, next.state.X, 0});
  steps_.push_back(next);
}

motion::Sample IntegratedMotion::at(double t) {
  require_finite("t", t);
  if (!(t >= 0 && t <= longest_)) {
    throw OutOfRange("t", "is beyond the integrated motion", {t, 0, longest_});
  }
  if (t == 0) return {t, body_.attitude(), body_.initial_rate()};
  while (steps_.back().t <= t) advance();
  const auto after = std::ranges::upper_bound(steps_, t, {}, &Step::t);
  const auto step = static_cast<std::size_t>(after - steps_.begin()) - 1;
  expand(step);
  return series_.sample(t, series_.at(t - steps_[step].t));
}

std::size_t IntegratedMotion::flips_until(double t) {
  at(t);
  const std::vector<double>& times = flips_.times();
  return static_cast<std::size_t>(std::ranges::upper_bound(times, t) - times.begin());
}

std::optional<double> IntegratedMotion::flip(std::size_t n) {
  const std::vector<double>& times = flips_.times();
  while (times.size() <= n && steps_.back().t < longest_) advance();
  if (times.size() <= n || times[n] > longest_) return std::nullopt;
  return times[n];
}

bool turns_over(const motion::FreeBody& body) {
  const Vector3d& I = body.principal().moments;
  const double G = body.momentum().stableNorm();
  const bool has_middle =
      !body::are_equal_moments(I[0], I[1]) && !body::are_equal_moments(I[1], I[2]);
  const Vector3d& m = body.body_momentum();
  const bool is_steady = m.cross(body.omega()).isZero(0.0);
  if (!has_middle || G == 0 || is_steady || body.energy_loss() > 0) return false;
  const Vector3d middle = body.principal().axes.col(1);
  const double wheel = middle.dot(body.interior().wheel) / G;
  double low = 1, high = -1;
  for (const Vector3d& mu :
       path_from(body.principal().axes.transpose() * m / G, EnergyContours(body))) {
    low = std::min(low, std::clamp(mu[1], -1.0, 1.0));
    high = std::max(high, std::clamp(mu[1], -1.0, 1.0));
  }
  // A wheel narrows the swing of a body that turns over.
  constexpr double least_swing = std::numbers::pi / 2;
  const double swing = std::acos(low) - std::acos(high);
  return swing >= least_swing && low < wheel && wheel < high;
}

}  // namespace twrench::page
