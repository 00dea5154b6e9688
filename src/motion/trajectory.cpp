#include "motion/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "base/error.h"
#include "motion/exact.h"
#include "motion/stepper.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;

// Sauer's step control, Numerical Analysis, section 6.5. The factor's bounds are the usual ones:
// an estimate that happens to vanish must not let the step run away, nor one bad step kill it.
constexpr double safety = 0.8;
constexpr double least_factor = 0.2;
constexpr double largest_factor = 5.0;

/// Walks along the method's own steps t_0 = 0, t_1, ... in the direction of `sign`.
class Walk {
 public:
  Walk(const FreeBody& body, const Method& method, const StepControl& control, double sign)
      : body_(body), method_(method), control_(control), next_length_(sign * control.step) {}

  /// The sample at t, which must not lie before the one asked for last.
  Sample sample_at(double t) {
    while (std::abs(t) > std::abs(t_next_)) advance();
    const Matrix3d X = t == t_next_ ? X_next_ : fixed_step(t - t_);
    require_finite(X, t);
    return {t, X, angular_velocity(body_, method_, X)};
  }

  /// The next of the method's own steps.
  OwnStep next_step() {
    advance();
    require_finite(X_next_, t_next_);
    return {t_, t_next_ - t_, X_, X_next_, error_};
  }

  std::int64_t steps() const { return steps_; }
  std::int64_t evaluations() const { return evaluations_; }

 private:
  /// Moves to the next of the method's own steps.
  void advance() {
    X_ = X_next_;
    t_ = t_next_;
    if (method_.adaptive()) {
      step_adaptively();
    } else {
      count_step();
      X_next_ = fixed_step(next_length_);
      t_next_ = static_cast<double>(steps_) * next_length_;  // never accumulated
    }
  }

  /// The end of a step of that very length from t_k.
  Matrix3d fixed_step(double length) {
    if (std::abs(length) > a_turn_) {
      throw UsageError(fmt::format("method {}", method_.name),
                       fmt::format("a step of {} s is longer than a turn of the body ({:.3g} s)",
                                   length, a_turn_),
                       "take a shorter --step");
    }
    const Step step = take_step(body_, method_, X_, length);
    evaluations_ += step.evaluations;
    if (std::isfinite(step.error)) return step.X;
    throw UsageError(fmt::format("method {}", method_.name),
                     fmt::format("a step of {} s turns the body too far for it", length),
                     "take a shorter --step");
  }

  void step_adaptively() {
    double length = next_length_;
    for (int attempt = 0;; ++attempt) {
      count_step();
      const double t_end = t_ + length;
      length = t_end - t_;  // as t can hold it, so that no time is lost to rounding
      if (!(std::abs(length) > 1e-15 * std::max(std::abs(t_), control_.step))) throw underflow();
      const Step step = take_step(body_, method_, X_, length);
      evaluations_ += step.evaluations;
      const double ratio = control_.tolerance / std::max(step.error, 1e-300);
      const double order = method_.tableau_order;
      const double factor =
          std::clamp(safety * std::pow(ratio, 1.0 / (order + 1.0)), least_factor, largest_factor);
      next_length_ = factor * length;
      if (step.error < control_.tolerance) {
        X_next_ = step.X;
        t_next_ = t_end;
        error_ = step.error;
        return;
      }
      length = attempt == 0 ? std::min(factor, 1.0) * length : 0.5 * length;
    }
  }

  void require_finite(const Matrix3d& X, double t) const {
    if (X.allFinite()) return;
    throw UsageError(fmt::format("method {}", method_.name),
                     fmt::format("the motion is no longer finite at t = {} s", t),
                     "take a shorter --step, or a method that stays on SO(3)");
  }

  void count_step() {
    if (++steps_ <= control_.max_steps) return;
    throw UsageError(fmt::format("method {}", method_.name),
                     fmt::format("more than {} steps at t = {} s", control_.max_steps, t_),
                     "take a longer --step, a larger --tolerance or a shorter --duration");
  }

  UsageError underflow() const {
    return {
        fmt::format("method {}", method_.name),
        fmt::format("the step underflows at t = {} s with tolerance {}", t_, control_.tolerance),
        "take a larger --tolerance, or a slower motion"};
  }

  const FreeBody& body_;
  const Method& method_;
  const StepControl& control_;
  const double a_turn_ = 2.0 * std::numbers::pi / body_.omega.norm();  ///< s; infinite at rest
  double next_length_;                                                 ///< signed
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
  double t_ = 0.0, t_next_ = 0.0;
  double error_ = 0.0;  ///< E of the step from t_ to t_next_
  Matrix3d X_ = Matrix3d::Identity(), X_next_ = Matrix3d::Identity();
};

/// The closed form goes to each time at once.
Trajectory exact_trajectory(const FreeBody& body, std::span<const double> times) {
  const ExactMotion motion(body);
  Trajectory result;
  result.samples.reserve(times.size());
  for (const double t : times) result.samples.push_back(motion.at(t));
  result.evaluations = static_cast<std::int64_t>(times.size());
  return result;
}

void visit_exact_steps(const FreeBody& body, double step, double t_end,
                       const std::function<void(const OwnStep&)>& visit) {
  const ExactMotion motion(body);
  Matrix3d before = Matrix3d::Identity();
  for (std::int64_t n = 0; static_cast<double>(n) * step < t_end; ++n) {
    const double t = static_cast<double>(n) * step;
    const Matrix3d after = motion.at(t + step).X;
    visit({t, step, before, after, 0.0});
    before = after;
  }
}

void require_tolerance(const Method& method, double tolerance) {
  if (!method.adaptive() || tolerance >= least_tolerance) return;
  throw UsageError("tolerance", fmt::format("is {}, but double precision keeps no less than {}",
                                            tolerance, least_tolerance));
}

}  // namespace

Trajectory trajectory(const FreeBody& body, const Method& method, const StepControl& control,
                      std::span<const double> times) {
  if (std::holds_alternative<ClosedForm>(method.scheme)) return exact_trajectory(body, times);
  require_tolerance(method, control.tolerance);
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::abs(times[i]); });
  Trajectory result;
  result.samples.resize(times.size());
  Walk forward(body, method, control, 1.0);
  Walk backward(body, method, control, -1.0);
  for (const std::size_t i : order) {
    result.samples[i] = (times[i] < 0.0 ? backward : forward).sample_at(times[i]);
  }
  result.steps = forward.steps() + backward.steps();
  result.evaluations = forward.evaluations() + backward.evaluations();
  return result;
}

void visit_steps(const FreeBody& body, const Method& method, const StepControl& control,
                 double t_end, const std::function<void(const OwnStep&)>& visit) {
  if (std::holds_alternative<ClosedForm>(method.scheme)) {
    return visit_exact_steps(body, control.step, t_end, visit);
  }
  require_tolerance(method, control.tolerance);
  Walk walk(body, method, control, 1.0);
  for (double t = 0.0; t < t_end;) {
    const OwnStep step = walk.next_step();
    visit(step);
    t = step.t + step.length;
  }
}

}  // namespace twrench
