#pragma once

#include <vector>

#include "motion/trajectory.h"

namespace twrench {

/// The true local error of a step: the Frobenius distance from its end to where the exact motion
/// that starts where the step does would be.
double local_error(const FreeBody& body, const OwnStep& step);

/// How honest the estimate E of an embedded pair is: the true local error of its accepted steps
/// against it. NaN where no step has an error above round-off.
struct EstimateQuality {
  double median_ratio;   ///< of true/E
  double largest_ratio;  ///< of true/E
  double largest_error;  ///< the true local error of the worst step
};

/// Gathers it over the steps of one trajectory.
class EstimateCheck {
 public:
  explicit EstimateCheck(const FreeBody& body) : body_(body) {}

  void visit(const OwnStep& step);
  EstimateQuality quality() const;

 private:
  const FreeBody& body_;
  double largest_error_ = 0.0;
  std::vector<double> ratios_;
};

}  // namespace twrench
