#include "check/hypotheses/readings.h"

#include <algorithm>
#include <limits>

#include "recording/informative_rows.h"
#include "table/error.h"

namespace twrench::check {

std::vector<Reading> readings(const recording::Recording& recording, const Eigen::Matrix3d& inertia,
                              std::span<const recording::Convention> conventions) {
  std::vector<Reading> all;
  for (const recording::Convention& convention : conventions) {
    try {
      const bool has_attitude = attitude_form(convention) != recording::AttitudeForm::none;
      all.push_back({convention, misfit(inertia, informative_rows(recording, convention),
                                        has_rates(convention), has_attitude)});
    } catch (const table::BadTable&) {
      const double infinite = std::numeric_limits<double>::infinity();
      all.push_back({convention, {infinite, infinite}});
    }
  }
  return all;
}

std::optional<Reading> only_fitting(std::vector<Reading> readings) {
  const auto worst = [](const Reading& reading) { return reading.misfit.worst().value_or(0); };
  std::ranges::sort(readings, {}, worst);
  if (readings.empty() || !readings[0].misfit.worst() || !readings[0].misfit.fits()) return {};
  if (readings.size() == 1) return readings[0];
  constexpr double far_worse = 5, contradicts = 1e-3;
  if (worst(readings[1]) < std::max(far_worse * worst(readings[0]), contradicts)) return {};
  return readings[0];
}

}  // namespace twrench::check
