#include <fmt/format.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/propagator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/require.h"
#include "motion/interior_series.h"
#include "motion/taylor.h"
#include "motion/unchecked.h"

namespace twrench::motion {

class Propagator::Engine {
 public:
  virtual ~Engine() = default;
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  virtual Sample sample_at(double t) = 0;
  virtual std::vector<Sample> samples_at(std::span<const double> times) {
    std::vector<Sample> samples;
    samples.reserve(times.size());
    for (const double t : times) samples.push_back(sample_at(t));
    return samples;
  }
  virtual AcceptedStep next_step() = 0;
  virtual double t() const = 0;
  virtual std::int64_t steps() const = 0;
  virtual std::int64_t evaluations() const = 0;
};

namespace {

using Eigen::Matrix3d;

// Sauer's step-size control, Numerical Analysis, section 6.5, with the usual bounds on the factor.
// They keep the step from growing without limit if an estimate happens to vanish, and from
// collapsing after one bad step.
constexpr double safety = 0.8;
constexpr double least_factor = 0.2;
constexpr double largest_factor = 5.0;

// Maximum length of an adaptive step in revolutions of the body. For constant omega the estimate
// vanishes and would allow any step, but a step beyond one revolution cannot be distinguished from
// a shorter one. dexpinv is also singular at a full revolution.
constexpr double longest_part = 0.9;

MotionError failure(const Method& method, MotionError::Reason reason, const std::string& why) {
  return {fmt::format("method {}", method.name), why, reason};
}

/// Throws unless the method may take step number `count`, which begins at t.
void require_allowed(std::int64_t count, const Method& method, const StepControl& control,
                     double t) {
  if (control.stop != nullptr && control.stop->load(std::memory_order_relaxed)) {
    throw failure(method, MotionError::Reason::stopped, fmt::format("stopped at t = {} s", t));
  }
  if (count <= control.max_steps) return;
  const auto reason =
      method.adaptive() ? MotionError::Reason::out_of_steps : MotionError::Reason::too_many_steps;
  throw failure(method, reason,
                fmt::format("more than {} steps at t = {} s", control.max_steps, t));
}

MotionError underflow(const Method& method, const StepControl& control, double t) {
  return failure(
      method, MotionError::Reason::step_underflow,
      fmt::format("the step underflows at t = {} s with tolerance {}", t, control.tolerance));
}

/// Throws if t lies before `start` in the direction of `sign`.
void require_ahead(double t, double start, double sign) {
  require_finite("t", t);
  if (sign * t >= sign * start) return;
  throw InvalidArgument("t", fmt::format("is {} s, before the step that begins at {} s", t, start));
}

/// Returns the time in s of a turn. A rigid body is assumed to turn at its initial rate, any other
/// at its fastest rate.
double turn_of(const FreeBody& body) {
  return 2.0 * std::numbers::pi / (body.is_rigid() ? body.omega().norm() : body.fastest_rate());
}

/// Advances through the method's accepted steps t_0 = 0, t_1, ... in the direction of `sign`.
class StepPropagator final : public Propagator::Engine {
 public:
  StepPropagator(const FreeBody& body, const Method& method, const StepControl& control,
                 double sign)
      : body_(body), method_(method), control_(control), sign_(sign), next_length_(sign * first_) {}

  Sample sample_at(double t) override {
    require_ahead(t, t_, sign_);
    while (std::abs(t) > std::abs(t_next_)) advance();
    if (t == 0) return {t, body_.attitude(), body_.initial_rate()};
    const Matrix3d X = t == t_next_ ? X_next_ : fixed_step(t - t_);
    const Sample sample{t, X, unchecked::angular_velocity(body_, method_, X)};
    require_sane(sample);
    return sample;
  }

  AcceptedStep next_step() override {
    advance();
    require_sane({t_next_, X_next_, unchecked::angular_velocity(body_, method_, X_next_)});
    return {t_, t_next_ - t_, X_, X_next_, error_};
  }

  double t() const override { return t_next_; }
  std::int64_t steps() const override { return steps_; }
  std::int64_t evaluations() const override { return evaluations_; }

 private:
  /// Advances to the next accepted step.
  void advance() {
    X_ = X_next_;
    t_ = t_next_;
    require_allowed(++steps_, method_, control_, t_);
    if (method_.adaptive()) return step_adaptively();
    X_next_ = fixed_step(next_length_);
    t_next_ = static_cast<double>(steps_) * next_length_;  // never accumulated
  }

  /// Returns X at the end of a step of exactly this length from t_k.
  Matrix3d fixed_step(double length) {
    if (std::abs(length) > a_turn_) {
      throw failure(method_, MotionError::Reason::step_too_long,
                    fmt::format("a step of {} s is longer than a turn of the body ({:.3g} s)",
                                length, a_turn_));
    }
    const Step step = unchecked::take_step(body_, method_, X_, length);
    evaluations_ += step.evaluations;
    if (std::isfinite(step.error)) return step.X;
    throw failure(method_, MotionError::Reason::step_too_long,
                  fmt::format("a step of {} s is too long for this method", length));
  }

  double capped(double length) const {
    return std::clamp(length, -longest_part * a_turn_, longest_part * a_turn_);
  }

  void step_adaptively() {
    const double order = std::get<RungeKutta>(method_.scheme->kind).tableau.order;
    double length = next_length_;
    for (int attempt = 0;; ++attempt) {
      if (attempt > 0) require_allowed(++steps_, method_, control_, t_);
      const double t_end = t_ + length;
      length = t_end - t_;  // Rounded to what t can represent, so that no time is lost.
      if (!(std::abs(length) > 1e-15 * std::max(std::abs(t_), first_)))
        throw underflow(method_, control_, t_);
      const Step step = unchecked::take_step(body_, method_, X_, length);
      evaluations_ += step.evaluations;
      const double ratio = control_.tolerance / std::max(step.error, 1e-300);
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

  /// Throws if X has diverged, as it may with a method that leaves SO(3). Beyond the bound,
  /// quantities computed from X would overflow.
  void require_sane(const Sample& sample) const {
    constexpr double bound = 1e50;
    if ((sample.X.array().abs() < bound).all() && (sample.omega.array().abs() < bound).all())
      return;
    throw failure(method_, MotionError::Reason::diverged,
                  fmt::format("the motion has diverged at t = {} s", sample.t));
  }

  const FreeBody body_;
  const Method method_;
  const StepControl control_;
  const double sign_;
  const double a_turn_ = turn_of(body_);  ///< s; infinite at rest
  const double first_ = method_.adaptive() ? capped(control_.step) : control_.step;
  double next_length_;  ///< signed
  std::int64_t steps_ = 0;
  std::int64_t evaluations_ = 0;
  double t_ = 0.0, t_next_ = 0.0;
  double error_ = 0.0;  ///< E of the step from t_ to t_next_.
  Matrix3d X_ = body_.attitude(), X_next_ = body_.attitude();
};

/// Advances from series to series. Each series serves all times within its step.
template <class Series>
class TaylorPropagator final : public Propagator::Engine {
 public:
  TaylorPropagator(const FreeBody& body, const Method& method, const StepControl& control,
                   double sign)
      : method_(method),
        control_(control),
        sign_(sign),
        start_{0, body.attitude(), body.initial_rate()},
        series_(body, std::get<Taylor>(method.scheme->kind)),
        state_next_(series_.state_of(body.attitude(), body.body_momentum())) {}

  Sample sample_at(double t) override {
    require_ahead(t, t_, sign_);
    while (steps_ == 0 || std::abs(t) > std::abs(t_next_)) advance();
    if (t == 0) return {t, start_.X, start_.omega};
    return series_.sample(t, t == t_next_ ? state_next_ : series_.at(t - t_));
  }

  AcceptedStep next_step() override {
    const Matrix3d before = series_.sample(t_next_, state_next_).X;
    advance();
    const double length = t_next_ - t_;
    return {t_, length, before, series_.sample(t_next_, state_next_).X, series_.last_terms(length)};
  }

  double t() const override { return t_next_; }
  std::int64_t steps() const override { return steps_; }
  std::int64_t evaluations() const override {
    return steps_ * std::get<Taylor>(method_.scheme->kind).order;
  }

 private:
  void advance() {
    require_allowed(++steps_, method_, control_, t_next_);
    series_.expand(state_next_);
    t_ = t_next_;
    const double t_end = t_ + sign_ * series_.max_step(control_.tolerance);
    if (!(std::abs(t_end) > std::abs(t_))) throw underflow(method_, control_, t_);
    state_next_ = series_.at(t_end - t_);
    t_next_ = t_end;
  }

  const Method method_;
  const StepControl control_;
  const double sign_;
  const Sample start_;
  Series series_;
  std::int64_t steps_ = 0;
  double t_ = 0.0, t_next_ = 0.0;
  typename Series::State state_next_;
};

/// Evaluates the closed form at each time.
class ExactPropagator final : public Propagator::Engine {
 public:
  ExactPropagator(const FreeBody& body, double signed_step)
      : motion_(body), step_(signed_step), X_(body.attitude()) {}

  Sample sample_at(double t) override {
    require_finite("t", t);
    ++evaluations_;
    return motion_.at(t);
  }

  std::vector<Sample> samples_at(std::span<const double> times) override {
    require_finite_entries("t", times);
    evaluations_ += static_cast<std::int64_t>(times.size());
    return motion_.at(times);
  }

  AcceptedStep next_step() override {
    const double start = t();
    const Matrix3d before = X_;
    X_ = sample_at(start + step_).X;
    ++made_;
    return {start, step_, before, X_, 0.0};
  }

  double t() const override { return static_cast<double>(made_) * step_; }
  std::int64_t steps() const override { return 0; }
  std::int64_t evaluations() const override { return evaluations_; }

 private:
  const ExactMotion motion_;
  const double step_;
  std::int64_t made_ = 0, evaluations_ = 0;
  Matrix3d X_;
};

void check(const Method& method, const StepControl& control) {
  require_positive("step", control.step);
  require_positive("max_steps", static_cast<double>(control.max_steps));
  if (!method.adaptive()) return;
  require_positive("tolerance", control.tolerance);
  if (control.tolerance >= min_tolerance) return;
  throw OutOfRange("tolerance",
                   fmt::format("is {}, but double precision keeps no less than {}",
                               control.tolerance, min_tolerance),
                   {control.tolerance, min_tolerance, std::numeric_limits<double>::max()});
}

}  // namespace

Propagator::Propagator(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}
Propagator::~Propagator() = default;

Sample Propagator::sample_at(double t) { return engine_->sample_at(t); }
std::vector<Sample> Propagator::samples_at(std::span<const double> times) {
  return engine_->samples_at(times);
}
AcceptedStep Propagator::next_step() { return engine_->next_step(); }
double Propagator::t() const { return engine_->t(); }
std::int64_t Propagator::steps() const { return engine_->steps(); }
std::int64_t Propagator::evaluations() const { return engine_->evaluations(); }

std::unique_ptr<Propagator> make_propagator(const FreeBody& body, const Method& method,
                                            const StepControl& control, Direction direction) {
  check(method, control);
  const double sign = direction == Direction::forward ? 1.0 : -1.0;
  std::unique_ptr<Propagator::Engine> engine;
  if (method.exact()) {
    engine = std::make_unique<ExactPropagator>(body, sign * control.step);
  } else if (std::holds_alternative<Taylor>(method.scheme->kind)) {
    if (body.is_rigid()) {
      engine = std::make_unique<TaylorPropagator<TaylorSeries>>(body, method, control, sign);
    } else {
      engine = std::make_unique<TaylorPropagator<InteriorSeries>>(body, method, control, sign);
    }
  } else {
    engine = std::make_unique<StepPropagator>(body, method, control, sign);
  }
  return std::make_unique<Propagator>(std::move(engine));
}

}  // namespace twrench::motion
