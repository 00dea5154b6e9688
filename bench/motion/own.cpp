#include <limits>

#include "motion/error.h"
#include "motion/method.h"
#include "motion/trajectory.h"
#include "problem.h"

namespace twrench::bench {
namespace {

Candidate candidate(const Method& method) {
  return {"twrench", std::string(method.name), method.adaptive() ? tolerances() : step_counts(),
          [&method](const Problem& problem, double parameter) -> Eigen::Matrix3d {
            StepControl control{.step = 0.1};
            if (method.adaptive()) {
              control.tolerance = std::max(parameter, least_tolerance);
            } else {
              control.step = problem.t_end / parameter;
            }
            const double times[] = {problem.t_end};
            try {
              return trajectory(problem.body, method, control, times).samples[0].X;
            } catch (const MotionError&) {  // a step too long for the method
              return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
            }
          }};
}

}  // namespace

std::vector<Candidate> own_candidates() {
  std::vector<Candidate> list;
  for (const Method& method : methods()) {
    if (method.order.value_or(0) > 2) list.push_back(candidate(method));
  }
  return list;
}

}  // namespace twrench::bench
