// Ten thousand attitudes during the motion, each within 1e-9 of the exact one: the closed form, the
// series, and the dense output of other libraries.
#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/trajectory.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <memory>
#include <sundials/sundials_context.hpp>

#include "problem.h"
#include "timing.h"

namespace twrench::bench {
namespace {

namespace odeint = boost::numeric::odeint;
using Attitudes = std::vector<Eigen::Matrix3d>;
using Form = VelocityForm;
using State = Form::State;

struct Sampler {
  std::string name;
  std::function<Attitudes(const Problem&, const std::vector<double>& times, double tolerance)> run;
};

Sampler own(const char* name) {
  return {
      fmt::format("twrench {}", name),
      [name](const Problem& problem, const std::vector<double>& times, double tolerance) {
        const motion::StepControl control{.tolerance = std::max(tolerance, motion::min_tolerance)};
        const motion::Method& method = motion::find_method(name);
        Attitudes result;
        result.reserve(times.size());
        for (const motion::Sample& s :
             motion::integrate(problem.body, method, control, times).samples) {
          result.push_back(s.X);
        }
        return result;
      }};
}

/// `make` takes a tolerance and returns a stepper with dense output.
template <class Make>
Sampler dense(const char* name, Make make) {
  return {fmt::format("odeint {}, dense output", name),
          [make](const Problem& problem, const std::vector<double>& times, double tolerance) {
            const Form form(problem.body);
            const auto system = [&form](const State& y, State& dydt, double) {
              form.rate(y.data(), dydt.data());
            };
            State y = form.start;
            Attitudes result;
            result.reserve(times.size());
            odeint::integrate_times(
                make(tolerance), system, y, times.begin(), times.end(), 0.1,
                [&](const State& at, double) { result.push_back(Form::attitude(at.data())); });
            return result;
          }};
}

Attitudes cvode(const Problem& problem, const std::vector<double>& times, double tolerance) {
  static const sundials::Context context;
  Form form(problem.body);
  N_Vector y = N_VNew_Serial(Form::size, context);
  std::ranges::copy(form.start, N_VGetArrayPointer(y));
  void* memory = CVodeCreate(CV_ADAMS, context);
  CVodeInit(
      memory,
      [](double, N_Vector at, N_Vector rate, void* data) {
        static_cast<const Form*>(data)->rate(N_VGetArrayPointer(at), N_VGetArrayPointer(rate));
        return 0;
      },
      0, y);
  CVodeSStolerances(memory, tolerance, tolerance);
  CVodeSetUserData(memory, &form);
  CVodeSetMaxNumSteps(memory, 1000);  // between two samples
  SUNNonlinearSolver solver = SUNNonlinSol_FixedPoint(y, 0, context);
  CVodeSetNonlinearSolver(memory, solver);
  Attitudes result{Eigen::Matrix3d::Identity()};
  result.reserve(times.size());
  for (std::size_t i = 1; i < times.size(); ++i) {
    double t = 0;
    if (CVode(memory, times[i], y, &t, CV_NORMAL) < 0) break;
    result.push_back(Form::attitude(N_VGetArrayPointer(y)));
  }
  SUNNonlinSolFree(solver);
  CVodeFree(&memory);
  N_VDestroy(y);
  return result;
}

std::vector<Sampler> samplers() {
  return {own("exact"),
          own("taylor"),
          dense("dopri5",
                [](double tolerance) {
                  return odeint::make_dense_output(tolerance, tolerance,
                                                   odeint::runge_kutta_dopri5<State>());
                }),
          dense("bulirsch_stoer",
                [](double tolerance) {
                  return odeint::bulirsch_stoer_dense_out<State>(tolerance, tolerance);
                }),
          {"SUNDIALS CVODE Adams", cvode}};
}

double worst(const Attitudes& found, const Attitudes& truth) {
  if (found.size() < truth.size()) return std::numeric_limits<double>::infinity();
  double error = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double here = (found[i] - truth[i]).norm();
    if (!(here <= error)) error = here;  // NaN too
  }
  return error;
}

}  // namespace

void compare_samples(const Problem& problem, int rounds) {
  constexpr int count = 10'000;
  constexpr double level = 1e-9, too_long = 0.02;
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(problem.t_end * i / count);
  Attitudes truth;
  const motion::ExactMotion motion(problem.body);
  for (const double t : times) truth.push_back(motion.at(t).X);

  fmt::print("\n{}: {} samples up to t = {} s, each within {} of the truth\n", problem.name, count,
             problem.t_end, level);
  double first = 0;
  for (const Sampler& sampler : samplers()) {
    double best = std::numeric_limits<double>::infinity(), chosen = 0;
    for (const double tolerance : tolerances()) {
      Attitudes found;
      const double seconds =
          seconds_at_best([&] { found = sampler.run(problem, times, tolerance); });
      if (worst(found, truth) <= level && seconds < best) best = seconds, chosen = tolerance;
      if (seconds > too_long) break;
    }
    if (!std::isfinite(best)) {
      fmt::print("  {:<40}not reached\n", sampler.name);
      continue;
    }
    for (int i = 0; i < rounds; ++i) {
      best = std::min(best, seconds_each([&] { sampler.run(problem, times, chosen); }));
    }
    if (first == 0) first = best;
    fmt::print("  {:<40}{:>10.1f} us{:>8.2f}{:>10.1e}\n", sampler.name, 1e6 * best, best / first,
               chosen);
  }
}

}  // namespace twrench::bench
