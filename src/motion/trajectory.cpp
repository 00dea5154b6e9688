#include <fmt/format.h>
#include <twrench/motion/error.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/require.h"
#include "motion/possible_steps.h"

namespace twrench::motion {
namespace {

/// Extrapolates the number of steps to t_end, in s, from the first steps that the method chooses;
/// 0 if they reach it.
double estimated_steps(const FreeBody& body, const Method& method, const StepControl& control,
                       double t_end) {
  constexpr int first_steps = 1024;
  const auto propagator = make_propagator(body, method, control);
  for (int i = 0; i < first_steps; ++i) {
    propagator->next_step();
    if (propagator->t() >= t_end) return 0;
  }
  return first_steps * (t_end / propagator->t());
}

/// Throws if the steps that a method chooses would exceed the limit by far, instead of after
/// minutes. Motions without many turns are not tried.
void require_few_own_steps(const FreeBody& body, const Method& method, const StepControl& control,
                           double t_end) {
  const auto most = static_cast<double>(control.max_steps);
  constexpr double turns_per_step = 1e-3;
  if (!(std::abs(t_end) * body.fastest_rate() > turns_per_step * most)) return;
  constexpr double by_far = 2;  // later steps may be longer
  const double steps = estimated_steps(body, method, control, std::abs(t_end));
  if (!(steps > by_far * most)) return;
  throw MotionError(fmt::format("method {}", method.name),
                    fmt::format("about {:.2g} steps to t = {} s are more than {}", steps, t_end,
                                control.max_steps),
                    MotionError::Reason::out_of_steps);
}

/// Returns the time `t` of a sample. Throws unless it is finite, not negative and not before
/// `last`.
double require_not_before(double last, double t) {
  require_not_negative("time", t);
  if (t >= last) return t;
  throw InvalidArgument("time", fmt::format("is {} s after {} s, but must ascend", t, last));
}

}  // namespace

void require_possible(const FreeBody& body, const Method& method, const StepControl& control,
                      double t_end) {
  if (method.adaptive()) return require_few_own_steps(body, method, control, t_end);
  const double steps = std::abs(t_end) / control.step;
  if (!(steps > static_cast<double>(control.max_steps))) return;
  throw MotionError(fmt::format("method {}", method.name),
                    fmt::format("{:.3g} steps of {} s to t = {} s are more than {}", steps,
                                control.step, t_end, control.max_steps),
                    MotionError::Reason::too_many_steps);
}

Trajectory integrate(const FreeBody& body, const Method& method, const StepControl& control,
                     std::span<const double> times) {
  require_finite_entries("time", times);
  const auto forward = make_propagator(body, method, control, Direction::forward);
  if (method.exact()) return {forward->samples_at(times), 0, forward->evaluations()};
  std::vector<std::size_t> order(times.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::abs(times[i]); });
  if (!order.empty()) require_possible(body, method, control, times[order.back()]);
  const auto backward = make_propagator(body, method, control, Direction::backward);
  Trajectory result;
  result.samples.resize(times.size());
  for (const std::size_t i : order) {
    result.samples[i] = (times[i] < 0.0 ? backward : forward)->sample_at(times[i]);
  }
  result.steps = forward->steps() + backward->steps();
  result.evaluations = forward->evaluations() + backward->evaluations();
  return result;
}

void visit_samples(const FreeBody& body, const Method& method, const StepControl& control,
                   std::size_t count, const std::function<double(std::size_t)>& time,
                   const std::function<void(const Sample&)>& visit) {
  if (!time) throw InvalidArgument("time", "is empty");
  if (!visit) throw InvalidArgument("visit", "is empty");
  const auto propagator = make_propagator(body, method, control);
  if (count > 0 && !method.exact()) {
    require_possible(body, method, control, require_not_negative("time", time(count - 1)));
  }
  // A stepping method delivers each sample before it continues, because a later step may fail.
  const std::size_t together = method.exact() ? 4096 : 1;
  std::vector<double> times;
  double last = 0;
  for (std::size_t i = 0; i < count;) {
    times.clear();
    for (; i < count && times.size() < together; ++i) {
      times.push_back(require_not_before(last, time(i)));
      last = times.back();
    }
    std::ranges::for_each(propagator->samples_at(times), visit);
  }
}

void visit_steps(const FreeBody& body, const Method& method, const StepControl& control,
                 double t_end, const std::function<void(const AcceptedStep&)>& visit) {
  require_not_negative("t_end", t_end);
  if (!visit) throw InvalidArgument("visit", "is empty");
  const auto propagator = make_propagator(body, method, control);
  require_possible(body, method, control, t_end);
  while (propagator->t() < t_end) visit(propagator->next_step());
}

}  // namespace twrench::motion
