#include "method_run.h"

#include <twrench/motion/error.h>
#include <twrench/motion/stepper.h>

#include <algorithm>
#include <limits>
#include <string>

#include "base/require.h"

namespace twrench::page {
namespace {

/// These steps take 40 MB.
constexpr std::size_t most_remembered = 500'000;

}  // namespace

MethodRun::MethodRun(const motion::FreeBody& body, const motion::Method& method,
                     const motion::StepControl& control)
    : body_(body),
      method_(method),
      propagator_(motion::make_propagator(body_, method_, control)),
      flips_(body_, method_) {}

void MethodRun::advance(double t, std::size_t most) {
  for (std::size_t n = 0; n < most && propagator_->t() < t; ++n) {
    if (begins_.size() == most_remembered) {
      throw motion::MotionError("method " + std::string(method_.name),
                                "more steps than a page can keep",
                                motion::MotionError::Reason::out_of_steps);
    }
    const motion::AcceptedStep step = propagator_->next_step();
    begins_.push_back({step.t, step.before});
    flips_.visit(step);
  }
}

motion::Sample MethodRun::at(double t) {
  require_finite("t", t);
  if (t < 0) {
    throw OutOfRange("t", "a method goes forward from t = 0",
                     {t, 0, std::numeric_limits<double>::infinity()});
  }
  advance(t, most_remembered + 1);
  if (begins_.empty() || t >= begins_.back().t) return propagator_->sample_at(t);
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), t,
                                      [](double time, const Begin& b) { return time < b.t; });
  const Begin& begin = *(after - 1);
  if (t == 0) return {t, begin.X, body_.initial_rate()};
  const Eigen::Matrix3d X =
      t == begin.t ? begin.X : motion::take_step(body_, method_, begin.X, t - begin.t).X;
  return {t, X, motion::angular_velocity(body_, method_, X)};
}

}  // namespace twrench::page
