#pragma once

#include <vector>

#include "motion/trajectory.h"

namespace twrench {

/// Finds when the component of omega along the intermediate axis changes sign in the motion as a
/// method computes it: between the ends of each of its steps, then by root finding on the method's
/// own samples within the step. Two changes within one step are not seen.
class FlipSearch {
 public:
  FlipSearch(const FreeBody& body, const Method& method) : body_(body), method_(method) {}

  /// To be called for each step, in their order.
  void visit(const OwnStep& step);

  /// The instants so far, s, ascending.
  const std::vector<double>& times() const { return times_; }

 private:
  double component(const Eigen::Matrix3d& X) const;
  double root(const OwnStep& step, double at_start, double at_end) const;

  const FreeBody& body_;
  const Method& method_;
  double sign_ = 0.0;  ///< that of the component when it was not zero last; 0 before that
  std::vector<double> times_;
};

}  // namespace twrench
