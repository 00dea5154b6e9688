#pragma once

#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <atomic>
#include <optional>
#include <vector>

// The motion to round-off: the closed form or, where there is none, the method `taylor`.

namespace twrench::motion {

/// Returns the method that computes the body's motion to round-off, with reference_control().
const Method& reference_method(const FreeBody& body);

/// Returns the step control of reference_method(): its steps fit into memory and take seconds.
/// Another thread can end the integration through `stop`, as in StepControl.
inline StepControl reference_control(const std::atomic<bool>* stop = nullptr) {
  return {.tolerance = min_tolerance, .max_steps = 2'000'000, .stop = stop};
}

/// The motion at any time from 0 to an end, in any order.
class ReferenceMotion {
 public:
  /// `end` in s, >= 0. Throws MotionError as visit_steps() does.
  ReferenceMotion(const FreeBody& body, double end, const std::atomic<bool>* stop = nullptr);

  /// Returns the sample at t in s.
  Sample at(double t) const;

 private:
  /// The state from which the method continues.
  struct Start {
    double t;
    Eigen::Matrix3d X;
  };

  FreeBody body_;
  std::optional<ExactMotion> exact_;
  std::vector<Start> starts_;  ///< In ascending order of t; empty if there is a closed form.
};

}  // namespace twrench::motion
