#include "study/reference.h"

#include <twrench/motion/exact.h>
#include <twrench/motion/stepper.h>
#include <twrench/study/flip_search.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/interior_series.h"
#include "motion/reference_motion.h"

namespace twrench::study {
namespace {

using motion::InteriorSeries;

/// Every body without a closed form has a wheel or loses energy.
std::vector<Eigen::Matrix3d> series_ends(const motion::FreeBody& body, const motion::Taylor& method,
                                         std::span<const motion::AcceptedStep> steps) {
  constexpr std::size_t lanes = InteriorSeries::lanes;
  // In a quarter of a radian, the last terms of the series fall below round-off.
  constexpr double longest = 0.25;
  const double rate = body.fastest_rate();
  const InteriorSeries prototype(body, method);
  std::array<InteriorSeries, lanes> series{prototype, prototype, prototype, prototype,
                                           prototype, prototype, prototype, prototype};
  std::vector<Eigen::Matrix3d> ends(steps.size());
  for (std::size_t first = 0; first < steps.size(); first += lanes) {
    const std::size_t count = std::min(lanes, steps.size() - first);
    std::array<InteriorSeries::State, lanes> states;
    std::array<double, lanes> parts{}, lengths{};
    for (std::size_t i = 0; i < lanes; ++i) {
      const motion::AcceptedStep& step = steps[first + std::min(i, count - 1)];
      states[i] = {step.before};
      parts[i] = std::max(1.0, std::ceil(std::abs(step.length) * rate / longest));
      lengths[i] = step.length / parts[i];
    }
    for (double part = 0; part < std::ranges::max(parts); ++part) {
      InteriorSeries::expand_together(series, states, lengths);
      for (std::size_t i = 0; i < count; ++i) {
        if (part < parts[i]) states[i] = series[i].at(lengths[i]);
      }
    }
    for (std::size_t i = 0; i < count; ++i) ends[first + i] = states[i].X;
  }
  return ends;
}

}  // namespace

std::vector<motion::Sample> reference_at(const motion::FreeBody& body,
                                         std::span<const double> times) {
  return motion::integrate(body, motion::reference_method(body), motion::reference_control(), times)
      .samples;
}

std::vector<Eigen::Matrix3d> reference_ends(const motion::FreeBody& body,
                                            std::span<const motion::AcceptedStep> steps) {
  const motion::Method& method = motion::reference_method(body);
  if (!method.exact())
    return series_ends(body, std::get<motion::Taylor>(method.scheme->kind), steps);
  std::vector<Eigen::Matrix3d> ends;
  for (const motion::AcceptedStep& step : steps) {
    ends.push_back(motion::take_step(body, method, step.before, step.length).X);
  }
  return ends;
}

std::vector<double> flip_times(const motion::FreeBody& body, const motion::Method& method,
                               const motion::StepControl& control, double t_end) {
  if (method.exact()) return motion::ExactMotion(body).flip_times(t_end);
  FlipSearch search(body, method);
  motion::visit_steps(body, method, control, t_end,
                      [&](const motion::AcceptedStep& step) { search.visit(step); });
  return search.times();
}

std::vector<double> reference_flip_times(const motion::FreeBody& body, double t_end) {
  std::vector<double> times =
      flip_times(body, motion::reference_method(body), motion::reference_control(), t_end);
  std::erase_if(times, [&](double t) { return t > t_end; });
  return times;
}

}  // namespace twrench::study
