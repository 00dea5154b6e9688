#pragma once

#include <twrench/motion/trajectory.h>

#include <span>
#include <vector>

namespace twrench::study {

/// Returns the true local error of a step: the Frobenius distance between its end and the exact
/// motion (or that of `taylor`, if there is no closed form) from its beginning. Throws OutOfRange
/// about "X", "after" or "h" if the beginning, the end or the length of the step is not finite.
double local_error(const motion::FreeBody& body, const motion::AcceptedStep& step);

/// The quality of an embedded pair's error estimate E, compared with the true local errors of
/// accepted steps. NaN if no step has an error above round-off.
struct EstimateQuality {
  double median_ratio;   ///< Median of true/E.
  double largest_ratio;  ///< Maximum of true/E.
  double largest_error;  ///< Largest true local error of a step.
};

/// Accumulates the quality over the steps of a trajectory.
class EstimateCheck {
 public:
  /// Keeps a copy of `body`.
  explicit EstimateCheck(const motion::FreeBody& body) : body_(body) {}

  /// Adds the next step. Throws as local_error() does, and OutOfRange about "error" unless that of
  /// the step is finite and not negative.
  void visit(const motion::AcceptedStep& step) { visit({&step, 1}); }
  /// Adds the next steps, at a fraction of the cost and with the same result. Throws as the other
  /// overload does, before any is added.
  void visit(std::span<const motion::AcceptedStep> steps);
  /// Returns the quality over the steps so far.
  EstimateQuality quality() const;

 private:
  motion::FreeBody body_;
  double largest_error_ = 0.0;
  std::vector<double> ratios_;
};

}  // namespace twrench::study
