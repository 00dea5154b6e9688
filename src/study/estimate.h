#pragma once

#include <vector>

#include "motion/trajectory.h"

namespace twrench {

/// Returns the true local error of a step: the Frobenius distance between its end and the exact
/// motion started from its beginning.
double local_error(const FreeBody& body, const OwnStep& step);

/// The quality of an embedded pair's error estimate E: the true local errors of accepted steps
/// compared with it. NaN if no step has an error above round-off.
struct EstimateQuality {
  double median_ratio;   ///< Median of true/E.
  double largest_ratio;  ///< Maximum of true/E.
  double largest_error;  ///< Largest true local error of a step.
};

/// Accumulates the quality over the steps of a trajectory.
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
