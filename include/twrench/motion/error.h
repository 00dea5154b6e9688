#pragma once

#include <twrench/base/error.h>

namespace twrench::motion {

/// A motion cannot be computed in the way that was asked for, though each value is allowed.
class MotionError : public Error {
 public:
  /// Why it cannot.
  enum class Reason {
    step_too_long,   ///< a fixed step is longer than a turn of the body, or than the method takes
    diverged,        ///< a method that leaves SO(3) has gone too far from it
    too_many_steps,  ///< fixed ones, counted before the first is taken
    out_of_steps,    ///< an adaptive method has taken as many as it may
    step_underflow,  ///< an adaptive method finds no step that meets its tolerance
    too_many_flips,  ///< more flip times than can be listed
    stopped,         ///< by StepControl::stop
  };

  /// What failed and why, in words and as one of the reasons.
  MotionError(const std::string& what, const std::string& why, Reason reason)
      : Error(what, why), reason_(reason) {}
  /// Copies it.
  MotionError(const MotionError&) = default;
  /// Copies it.
  MotionError& operator=(const MotionError&) = default;
  ~MotionError() override;

  /// Why, as one of the reasons.
  Reason reason() const noexcept { return reason_; }

 private:
  Reason reason_;
};

}  // namespace twrench::motion
