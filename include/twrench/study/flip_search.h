#pragma once

#include <twrench/motion/trajectory.h>

#include <optional>
#include <vector>

namespace twrench::study {

/// Finds the times at which the component of the momentum in the body along the intermediate axis
/// changes sign in a method's own solution, of a body that loses no energy: it brackets them
/// between the ends of each step, then finds the root on the method's own samples within the step.
/// Two sign changes within one step are missed.
class FlipSearch {
 public:
  /// Keeps copies of `body` and `method`.
  FlipSearch(const motion::FreeBody& body, const motion::Method& method)
      : body_(body), method_(method) {}

  /// Processes the next step. Throws OutOfRange about "length" unless that of the step is positive,
  /// about "t" or "X" unless it is finite, and InvalidArgument about "t" unless the step begins
  /// after the previous one.
  void visit(const motion::AcceptedStep& step);

  /// Returns the times found so far in s, ascending.
  const std::vector<double>& times() const { return times_; }

 private:
  /// Returns the component divided by the intermediate moment.
  double component(const Eigen::Matrix3d& X) const;
  double root(const motion::AcceptedStep& step, double at_start, double at_end) const;

  motion::FreeBody body_;
  motion::Method method_;
  double sign_ = 0.0;           ///< Sign of the component when it was last nonzero; 0 before that.
  std::optional<double> last_;  ///< Start of the last step in s.
  std::vector<double> times_;
};

}  // namespace twrench::study
