#include <twrench/motion/stepper.h>
#include <twrench/study/flip_search.h>

#include <cmath>

#include "base/require.h"
#include "motion/root.h"

namespace twrench::study {

double FlipSearch::component(const Eigen::Matrix3d& X) const {
  const Eigen::Vector3d axis = body_.principal().axes.col(1);
  const double of_wheel = axis.dot(body_.interior().wheel) / body_.principal().moments[1];
  return axis.dot(motion::angular_velocity(body_, method_, X)) + of_wheel;
}

void FlipSearch::visit(const motion::AcceptedStep& step) {
  require_positive("length", step.length);
  require_finite("t", step.t);
  if (last_ && !(step.t > *last_)) {
    throw InvalidArgument("t", "the steps must be visited in their order");
  }
  const double before = component(step.before), after = component(step.after);
  last_ = step.t;
  // A method that leaves SO(3) may reach a singular X. The component is then not finite.
  if (!std::isfinite(before) || !std::isfinite(after)) return;
  if (sign_ == 0.0 && before != 0.0) sign_ = std::copysign(1.0, before);
  if (sign_ * after < 0.0) {
    times_.push_back(before == 0.0 ? step.t : step.t + root(step, before, after));
    sign_ = -sign_;
  }
}

double FlipSearch::root(const motion::AcceptedStep& step, double at_start, double at_end) const {
  const auto f = [&](double length) {
    const double value = component(motion::take_step(body_, method_, step.before, length).X);
    return std::isfinite(value) ? value : at_end;  // the search needs numbers, as in visit()
  };
  return motion::root_within(f, step.length, at_start, at_end);
}

}  // namespace twrench::study
