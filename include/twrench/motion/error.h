#pragma once

#include <twrench/base/error.h>

namespace twrench::motion {

/// A motion cannot be computed as requested, although each value is allowed.
class MotionError : public Error {
 public:
  /// The reason for the failure.
  enum class Reason {
    step_too_long,   ///< a fixed step exceeds a turn of the body or the method's limit
    diverged,        ///< a method that leaves SO(3) has strayed too far from it
    too_many_steps,  ///< more fixed steps than StepControl::max_steps
    out_of_steps,    ///< an adaptive method has taken StepControl::max_steps
    step_underflow,  ///< an adaptive method finds no step that meets its tolerance
    too_many_flips,  ///< more flip times than can be listed
    stopped,         ///< interrupted through StepControl::stop
  };

  /// `what` failed because of `why`, which `reason` classifies.
  MotionError(const std::string& what, const std::string& why, Reason reason)
      : Error(what, why), reason_(reason) {}
  /// Copies it.
  MotionError(const MotionError&) = default;
  /// Copies it.
  MotionError& operator=(const MotionError&) = default;
  ~MotionError() override;

  /// Returns the reason for the failure.
  Reason reason() const noexcept { return reason_; }

 private:
  Reason reason_;
};

}  // namespace twrench::motion
