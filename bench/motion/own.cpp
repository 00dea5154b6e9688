#include <twrench/motion/error.h>
#include <twrench/motion/method.h>
#include <twrench/motion/trajectory.h>

#include <limits>

#include "problem.h"

namespace twrench::bench {
namespace {

Candidate candidate(const motion::Method& method) {
  return {"twrench", std::string(method.name), method.adaptive() ? tolerances() : step_counts(),
          [&method](const Problem& problem, double parameter) -> Eigen::Matrix3d {
            motion::StepControl control{.step = 0.1};
            if (method.adaptive()) {
              control.tolerance = std::max(parameter, motion::min_tolerance);
            } else {
              control.step = problem.t_end / parameter;
            }
            const double times[] = {problem.t_end};
            try {
              return motion::integrate(problem.body, method, control, times).samples[0].X;
            } catch (const motion::MotionError&) {  // a step too long for the method
              return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
            }
          }};
}

}  // namespace

std::vector<Candidate> own_candidates() {
  std::vector<Candidate> list;
  for (const motion::Method& method : motion::methods()) {
    if (method.order.value_or(0) > 2) list.push_back(candidate(method));
  }
  return list;
}

}  // namespace twrench::bench
