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
#include "motion/taylor.h"

namespace twrench {
namespace {

using Eigen::Matrix3d;

// Sauer's step-size control, Numerical Analysis, section 6.5, with the usual bounds on the factor:
// an estimate that happens to vanish must not make the step grow without limit, nor one bad step
// make it collapse.
constexpr double safety = 0.8;
constexpr double least_factor = 0.2;
constexpr double largest_factor = 5.0;

// Maximum length of an adaptive step in revolutions of the body. For constant omega the estimate
// vanishes and would allow any step, but a step beyond one revolution cannot be distinguished from
// a shorter one; dexpinv is singular at a full revolution.
constexpr double longest_part = 0.9;

UsageError out_of_steps(const Method& method, const StepControl& control, double t) {
  return {fmt::format("method {}", method.name),
          fmt::format("more than {} steps at t = {} s", control.max_steps, t),
          "take a larger --tolerance or a shorter --duration"};
}

UsageError underflow(const Method& method, const StepControl& control, double t) {
  return {fmt::format("method {}", method.name),
          fmt::format("the step underflows at t = {} s with tolerance {}", t, control.tolerance),
          "take a larger --tolerance, or a slower motion"};
}

/// Advances through the method's accepted steps t_0 = 0, t_1, ... in the direction of `sign`.
class Walk {
 public:
  Walk(const FreeBody& body, const Method& method, const StepControl& control, double sign)
      : body_(body), method_(method), control_(control), next_length_(sign * first_) {}

  /// Returns the sample at t, which must not precede the previous one.
  Sample sample_at(double t) {
    while (std::abs(t) > std::abs(t_next_)) advance();
    const Matrix3d X = t == t_next_ ? X_next_ : fixed_step(t - t_);
    const Sample sample{t, X, angular_velocity(body_, method_, X)};
    require_sane(sample);
    return sample;
  }

  /// Returns the next accepted step.
  OwnStep next_step() {
    advance();
    require_sane({t_next_, X_next_, angular_velocity(body_, method_, X_next_)});
    return {t_, t_next_ - t_, X_, X_next_, error_};
  }

  std::int64_t steps() const { return steps_; }
  std::int64_t evaluations() const { return evaluations_; }

 private:
  /// Advances to the next accepted step.
  void advance() {
    X_ = X_next_;
    t_ = t_next_;
    if (method_.adaptive()) {
      step_adaptively();
    } else {
      ++steps_;  // require_possible has checked that there are not too many
      X_next_ = fixed_step(next_length_);
      t_next_ = static_cast<double>(steps_) * next_length_;  // never accumulated
    }
  }

  /// Returns the end of a step of exactly that length from t_k.
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
                     fmt::format("a step of {} s rotates the body too far for this method", length),
                     "take a shorter --step");
  }

  double capped(double length) const {
    return std::clamp(length, -longest_part * a_turn_, longest_part * a_turn_);
  }

  void step_adaptively() {
    double length = next_length_;
    for (int attempt = 0;; ++attempt) {
      if (++steps_ > control_.max_steps) throw out_of_steps(method_, control_, t_);
      const double t_end = t_ + length;
      length = t_end - t_;  // as t can represent it, so that no time is lost to rounding
      if (!(std::abs(length) > 1e-15 * std::max(std::abs(t_), first_)))
        throw underflow(method_, control_, t_);
      const Step step = take_step(body_, method_, X_, length);
      evaluations_ += step.evaluations;
      const double ratio = control_.tolerance / std::max(step.error, 1e-300);
      const double order = method_.tableau_order;
      const double factor =
          std::clamp(safety * std::pow(ratio, 1.0 / (order + 1.0)), least_factor, largest_factor);
      next_length_ = capped(factor * length);
      if (step.error < control_.tolerance) {
        X_next_ = step.X;
        t_next_ = t_end;
        error_ = step.error;
        return;
      }
      length = attempt == 0 ? std::min(factor, 1.0) * length : 0.5 * length;
    }
  }

  /// For a method that leaves SO(3): beyond this bound, quantities computed from X would overflow.
  void require_sane(const Sample& sample) const {
    constexpr double bound = 1e50;
    if ((sample.X.array().abs() < bound).all() && (sample.omega.array().abs() < bound).all())
      return;
    throw UsageError(fmt::format("method {}", method_.name),
                     fmt::format("the motion diverged at t = {} s", sample.t),
                     "take a shorter --step, or a method that stays on SO(3)");
  }

  const FreeBody& body_;
  const Method& method_;
  const StepControl& control_;
  const double a_turn_ = 2.0 * std::numbers::pi / body_.omega.norm();  ///< s; infinite at rest
  const double first_ = method_.adaptive() ? capped(control_.step) : control_.step;
  double next_length_;  ///< signed
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
  double t_ = 0.0, t_next_ = 0.0;
  double error_ = 0.0;  ///< E of the step from t_ to t_next_
  Matrix3d X_ = Matrix3d::Identity(), X_next_ = Matrix3d::Identity();
};

/// Advances from series to series; each serves all times within its step.
class TaylorWalk {
 public:
  TaylorWalk(const FreeBody& body, const Method& method, const StepControl& control, double sign)
      : method_(method),
        control_(control),
        sign_(sign),
        series_(body, std::get<Taylor>(method.scheme)),
        state_next_(series_.state_of(Matrix3d::Identity(), body.momentum)) {}

  Sample sample_at(double t) {
    while (steps_ == 0 || std::abs(t) > std::abs(t_next_)) advance();
    return series_.sample(t, t == t_next_ ? state_next_ : series_.at(t - t_));
  }

  OwnStep next_step() {
    const Matrix3d before = series_.sample(t_next_, state_next_).X;
    advance();
    const double length = t_next_ - t_;
    return {t_, length, before, series_.sample(t_next_, state_next_).X, series_.last_terms(length)};
  }

  std::int64_t steps() const { return steps_; }
  std::int64_t evaluations() const { return steps_ * method_.order; }

 private:
  void advance() {
    if (++steps_ > control_.max_steps) throw out_of_steps(method_, control_, t_next_);
    series_.expand(state_next_);
    t_ = t_next_;
    const double t_end = t_ + sign_ * series_.reach(control_.tolerance);
    if (!(std::abs(t_end) > std::abs(t_))) throw underflow(method_, control_, t_);
    state_next_ = series_.at(t_end - t_);
    t_next_ = t_end;
  }

  const Method& method_;
  const StepControl& control_;
  double sign_;
  TaylorSeries series_;
  std::int64_t steps_ = 0;
  double t_ = 0.0, t_next_ = 0.0;
  TaylorSeries::State state_next_;
};

/// The closed form evaluates each time directly.
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

/// Checks what can be known before the first step to t_end, in s.
void require_possible(const Method& method, const StepControl& control, double t_end) {
  if (method.adaptive()) {
    if (control.tolerance >= least_tolerance) return;
    throw UsageError("tolerance", fmt::format("is {}, but double precision keeps no less than {}",
                                              control.tolerance, least_tolerance));
  }
  const double steps = std::abs(t_end) / control.step;
  if (!(steps > static_cast<double>(control.max_steps))) return;
  throw UsageError(fmt::format("method {}", method.name),
                   fmt::format("{:.3g} steps of {} s to t = {} s are more than {}", steps,
                               control.step, t_end, control.max_steps),
                   "take a longer --step or a shorter --duration");
}

/// Computes all samples with positive times, and then all with negative ones, by advancing `Kind`.
template <class Kind>
Trajectory walk(const FreeBody& body, const Method& method, const StepControl& control,
                std::span<const double> times) {
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::abs(times[i]); });
  if (!order.empty()) require_possible(method, control, times[order.back()]);
  Trajectory result;
  result.samples.resize(times.size());
  Kind forward(body, method, control, 1.0);
  Kind backward(body, method, control, -1.0);
  for (const std::size_t i : order) {
    result.samples[i] = (times[i] < 0.0 ? backward : forward).sample_at(times[i]);
  }
  result.steps = forward.steps() + backward.steps();
  result.evaluations = forward.evaluations() + backward.evaluations();
  return result;
}

}  // namespace

Trajectory trajectory(const FreeBody& body, const Method& method, const StepControl& control,
                      std::span<const double> times) {
  if (std::holds_alternative<ClosedForm>(method.scheme)) return exact_trajectory(body, times);
  return std::holds_alternative<Taylor>(method.scheme)
             ? walk<TaylorWalk>(body, method, control, times)
             : walk<Walk>(body, method, control, times);
}

void visit_samples(const FreeBody& body, const Method& method, const StepControl& control,
                   std::size_t count, const std::function<double(std::size_t)>& time,
                   const std::function<void(const Sample&)>& visit) {
  const auto visit_all = [&](auto sample_at) {
    for (std::size_t i = 0; i < count; ++i) visit(sample_at(time(i)));
  };
  if (std::holds_alternative<ClosedForm>(method.scheme)) {
    return visit_all([motion = ExactMotion(body)](double t) { return motion.at(t); });
  }
  if (count > 0) require_possible(method, control, time(count - 1));
  if (std::holds_alternative<Taylor>(method.scheme)) {
    TaylorWalk walk(body, method, control, 1.0);
    visit_all([&](double t) { return walk.sample_at(t); });
  } else {
    Walk walk(body, method, control, 1.0);
    visit_all([&](double t) { return walk.sample_at(t); });
  }
}

void visit_steps(const FreeBody& body, const Method& method, const StepControl& control,
                 double t_end, const std::function<void(const OwnStep&)>& visit) {
  require_possible(method, control, t_end);
  if (std::holds_alternative<ClosedForm>(method.scheme)) {
    return visit_exact_steps(body, control.step, t_end, visit);
  }
  const auto visit_all = [&](auto walk) {
    for (double t = 0.0; t < t_end;) {
      const OwnStep step = walk.next_step();
      visit(step);
      t = step.t + step.length;
    }
  };
  if (std::holds_alternative<Taylor>(method.scheme)) {
    visit_all(TaylorWalk(body, method, control, 1.0));
  } else {
    visit_all(Walk(body, method, control, 1.0));
  }
}

}  // namespace twrench
