#include <twrench/study/estimate.h>

#include <algorithm>
#include <limits>

#include "base/require.h"
#include "study/ladder.h"
#include "study/reference.h"

namespace twrench::study {

double local_error(const motion::FreeBody& body, const motion::AcceptedStep& step) {
  require_finite_entries("after", step.after);
  require_finite_entries("X", step.before);
  require_finite("h", step.length);
  return (step.after - reference_step(body, step.before, step.length)).norm();
}

void EstimateCheck::visit(const motion::AcceptedStep& step) {
  constexpr double round_off = 1e-14;
  require_not_negative("error", step.error);
  const double error = local_error(body_, step);
  largest_error_ = std::max(largest_error_, error);
  if (error > round_off) ratios_.push_back(error / step.error);
}

EstimateQuality EstimateCheck::quality() const {
  if (ratios_.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, largest_error_};
  }
  return {median(ratios_), std::ranges::max(ratios_), largest_error_};
}

}  // namespace twrench::study
