#pragma once

#include <twrench/motion/propagator.h>
#include <twrench/study/flip_search.h>

#include <memory>
#include <vector>

namespace twrench::page {

/// Integrates a motion forward with a method and records the beginning of each step, so that a page
/// can show any time that was reached.
class MethodRun {
 public:
  /// Throws OutOfRange if the step or the tolerance is out of range.
  MethodRun(const motion::FreeBody& body, const motion::Method& method,
            const motion::StepControl& control);
  MethodRun(const MethodRun&) = delete;
  MethodRun& operator=(const MethodRun&) = delete;

  /// Takes steps until t in s is reached, but at most `most`. Throws MotionError.
  void advance(double t, std::size_t most);

  /// Returns the sample at t >= 0 in s, and takes missing steps if necessary. Throws OutOfRange and
  /// MotionError.
  motion::Sample at(double t);

  double reached() const { return propagator_->t(); }                      ///< s
  std::int64_t steps() const { return propagator_->steps(); }              ///< rejected ones too
  std::int64_t evaluations() const { return propagator_->evaluations(); }  ///< of omega
  /// Returns the times of the flips in the method's solution so far, s.
  const std::vector<double>& flip_times() const { return flips_.times(); }

 private:
  struct Begin {
    double t;           ///< s
    Eigen::Matrix3d X;  ///< space_from_body
  };

  motion::FreeBody body_;
  motion::Method method_;
  std::unique_ptr<motion::Propagator> propagator_;
  study::FlipSearch flips_;
  std::vector<Begin> begins_;
};

}  // namespace twrench::page
