#include <twrench/study/estimate.h>

#include <algorithm>
#include <limits>

#include "base/require.h"
#include "study/ladder.h"
#include "study/reference.h"

namespace twrench::study {
namespace {

std::vector<double> local_errors(const motion::FreeBody& body,
                                 std::span<const motion::AcceptedStep> steps) {
  for (const motion::AcceptedStep& step : steps) {
    require_finite_entries("after", step.after);
    require_finite_entries("X", step.before);
    require_finite("h", step.length);
  }
  const std::vector<Eigen::Matrix3d> ends = reference_ends(body, steps);
  std::vector<double> errors(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) errors[i] = (steps[i].after - ends[i]).norm();
  return errors;
}

}  // namespace

double local_error(const motion::FreeBody& body, const motion::AcceptedStep& step) {
  return local_errors(body, {&step, 1})[0];
}

void EstimateCheck::visit(std::span<const motion::AcceptedStep> steps) {
  constexpr double round_off = 1e-14;
  for (const motion::AcceptedStep& step : steps) require_not_negative("error", step.error);
  const std::vector<double> errors = local_errors(body_, steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    largest_error_ = std::max(largest_error_, errors[i]);
    if (errors[i] > round_off) ratios_.push_back(errors[i] / steps[i].error);
  }
}

EstimateQuality EstimateCheck::quality() const {
  if (ratios_.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, largest_error_};
  }
  return {median(ratios_), std::ranges::max(ratios_), largest_error_};
}

}  // namespace twrench::study
