#include "study/reference.h"

#include <twrench/motion/exact.h>
#include <twrench/motion/stepper.h>
#include <twrench/study/flip_search.h>

#include <cmath>

#include "motion/reference_motion.h"

namespace twrench::study {

std::vector<motion::Sample> reference_at(const motion::FreeBody& body,
                                         std::span<const double> times) {
  return motion::integrate(body, motion::reference_method(body), motion::reference_control(), times)
      .samples;
}

Eigen::Matrix3d reference_step(const motion::FreeBody& body, const Eigen::Matrix3d& X,
                               double length) {
  const motion::Method& method = motion::reference_method(body);
  // In a quarter of a radian, the last terms of the series fall below round-off.
  const double parts =
      method.exact() ? 1 : std::ceil(std::abs(length) * body.fastest_rate() / 0.25);
  Eigen::Matrix3d end = X;
  for (double i = 0; i < parts; ++i) end = motion::take_step(body, method, end, length / parts).X;
  return end;
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
