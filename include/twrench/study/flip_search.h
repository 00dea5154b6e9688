#pragma once

#include <twrench/motion/trajectory.h>

#include <vector>

namespace twrench::study {

/// Finds the times at which the component of omega along the intermediate axis changes sign in a
/// method's own solution: it brackets them between the ends of each step, then finds the root on
/// the method's own samples within the step. Two sign changes within one step are missed.
class FlipSearch {
 public:
  /// Refers to `body` and `method`, which must outlive the search.
  FlipSearch(const motion::FreeBody& body, const motion::Method& method)
      : body_(body), method_(method) {}

  /// Processes the next step; steps must arrive in order.
  void visit(const motion::AcceptedStep& step);

  /// Returns the times found so far in s, ascending.
  const std::vector<double>& times() const { return times_; }

 private:
  double component(const Eigen::Matrix3d& X) const;
  double root(const motion::AcceptedStep& step, double at_start, double at_end) const;

  const motion::FreeBody& body_;
  const motion::Method& method_;
  double sign_ = 0.0;  ///< Sign of the component when it was last nonzero; 0 before that.
  std::vector<double> times_;
};

}  // namespace twrench::study
