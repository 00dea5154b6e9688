#include "motion/reference_motion.h"

#include <twrench/motion/stepper.h>

#include <algorithm>
#include <iterator>

namespace twrench::motion {

const Method& reference_method(const FreeBody& body) {
  static const Method& exact = find_method("exact");
  static const Method& taylor = find_method("taylor");
  return ExactMotion::covers(body) ? exact : taylor;
}

ReferenceMotion::ReferenceMotion(const FreeBody& body, double end, const std::atomic<bool>* stop)
    : body_(body) {
  const Method& method = reference_method(body_);
  if (method.exact()) {
    exact_.emplace(body_);
    return;
  }
  starts_.push_back({0, body_.attitude()});
  visit_steps(body_, method, reference_control(stop), end, [&](const AcceptedStep& step) {
    starts_.push_back({step.t + step.length, step.after});
  });
}

Sample ReferenceMotion::at(double t) const {
  if (exact_) return exact_->at(t);
  const auto later = std::ranges::upper_bound(starts_, t, {}, &Start::t);
  const Start& start = later == starts_.begin() ? *later : *std::prev(later);
  const Method& method = reference_method(body_);
  const Eigen::Matrix3d X =
      t == start.t ? start.X : take_step(body_, method, start.X, t - start.t).X;
  return {t, X, angular_velocity(body_, method, X)};
}

}  // namespace twrench::motion
