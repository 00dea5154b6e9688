#include <twrench/motion/diagnostics.h>
#include <twrench/motion/error.h>
#include <twrench/motion/propagator.h>
#include <twrench/motion/stepper.h>
#include <twrench/study/flip_search.h>
#include <twrench/study/study.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <mutex>

#include "base/parallel.h"
#include "base/require.h"
#include "motion/possible_steps.h"
#include "motion/reference_motion.h"
#include "study/ladder.h"
#include "study/reference.h"

namespace twrench::study {
namespace {

constexpr std::size_t time_parts = 200;

/// Returns the largest error of the flips that both solutions have. The method may find the last
/// ones only after the end, or not at all.
double flip_error(const std::vector<double>& predicted, const std::vector<double>& seen) {
  const std::size_t common = std::min(predicted.size(), seen.size());
  if (common == 0) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0.0;
  for (std::size_t i = 0; i < common; ++i) {
    largest = std::max(largest, std::abs(seen[i] - predicted[i]));
  }
  return largest;
}

/// Returns whether flips are searched for.
bool has_flips(const Study& study) {
  return study.reference->exact() ? study.flips.has_value() : !study.loses_energy;
}

/// The energy errors of a run. If the body loses energy, an error is the difference from the
/// reference.
class EnergyErrors {
 public:
  EnergyErrors(const motion::FreeBody& body, double duration, StudyRun& run)
      : body_(body),
        duration_(duration),
        run_(run),
        reference_(motion::make_propagator(body, motion::reference_method(body),
                                           motion::reference_control())) {
    run.drift_in_time.assign(time_parts, 0.0);
  }

  /// Adds the relative change of the energy from t = 0 to t.
  void add(double t, double change) {
    if (body_.energy_loss() == 0) return record(t, change);
    times_.push_back(t);
    changes_.push_back(change);
    if (times_.size() == most) compare();
  }

  /// Subtracts the changes of the reference from those added since the last call.
  void compare() {
    const double initial_energy = motion::energy(body_.inertia(), body_.omega());
    const std::vector<motion::Sample> samples = reference_->samples_at(times_);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const motion::Diagnostics d = motion::diagnose(body_, initial_energy, samples[i]);
      record(times_[i], changes_[i] - d.energy_drift);
    }
    times_.clear();
    changes_.clear();
  }

 private:
  static constexpr std::size_t most = 100'000;  // samples in memory

  void record(double t, double error) {
    run_.energy_drift = std::max(run_.energy_drift, std::abs(error));
    const double part = std::ceil(t / duration_ * time_parts) - 1.0;
    double& drift = run_.drift_in_time[std::min(static_cast<std::size_t>(part), time_parts - 1)];
    drift = std::max(drift, std::abs(error));
  }

  const motion::FreeBody& body_;
  double duration_;
  StudyRun& run_;
  std::unique_ptr<motion::Propagator> reference_;
  std::vector<double> times_, changes_;
};

/// A run of a method, and what it needs.
struct PlannedRun {
  const motion::Method* method;
  motion::StepControl control;
  StudyRun* result;
};

/// Takes the method's steps to the end, and collects errors, flips and the quality of the estimate.
/// `end` has the reference there.
void measure_steps(const motion::FreeBody& body, const PlannedRun& planned, const Study& study,
                   const motion::Sample& end) {
  const motion::Method& method = *planned.method;
  StudyRun& run = *planned.result;
  motion::require_possible(body, method, planned.control, study.duration);
  const auto propagator = motion::make_propagator(body, method, planned.control);
  const double initial_energy = motion::energy(body.inertia(), body.omega());
  FlipSearch flips(body, method);
  EstimateCheck estimate(body);
  EnergyErrors energy_errors(body, study.duration, run);
  std::vector<motion::AcceptedStep> estimated;
  constexpr std::size_t together = 128;  // in the nearest cache
  std::int64_t accepted = 0;
  while (propagator->t() < study.duration) {
    const motion::AcceptedStep step = propagator->next_step();
    ++accepted;
    const double t = step.t + step.length;
    const motion::Diagnostics d = motion::diagnose(
        body, initial_energy, {t, step.after, motion::angular_velocity(body, method, step.after)});
    energy_errors.add(t, d.energy_drift);
    run.orthogonality_error = std::max(run.orthogonality_error, d.orthogonality_error);
    run.momentum_error = std::max(run.momentum_error, d.momentum_error);
    if (has_flips(study)) flips.visit(step);
    if (method.adaptive()) estimated.push_back(step);
    if (estimated.size() == together) {
      estimate.visit(estimated);
      estimated.clear();
    }
  }
  estimate.visit(estimated);
  energy_errors.compare();
  run.error = (propagator->sample_at(study.duration).X - end.X).norm();
  run.steps = propagator->steps();
  // The steps of the closed form only serve the search for flips.
  run.evaluations = method.exact() ? 1 : propagator->evaluations();
  run.flips = flips.times();
  std::erase_if(run.flips, [&](double t) { return t > study.duration; });
  run.flip_error = flip_error(study.flip_times, run.flips);
  if (!method.adaptive()) return;
  run.step = study.duration / static_cast<double>(accepted);
  run.estimate = estimate.quality();
}

/// Does the work, or records why the method failed.
template <typename Work>
void record_failure(StudyRun& run, const Work& work) {
  if (!run.failure.empty()) return;
  try {
    work();
  } catch (const motion::MotionError& error) {
    if (error.reason() == motion::MotionError::Reason::stopped) throw;
    run.failure = error.what();
    run.failure_reason = error.reason();
  }
}

/// The cost of the first part of a run.
struct Cost {
  double cpu_seconds;
  std::int64_t evaluations;
};

/// Sets the error at the early time, and returns the cost from t = 0 to then or later: at least 2
/// ms, because the clock is coarse, of several calls if the whole run takes less. `early` has the
/// reference at the early time.
Cost measure_start(const motion::FreeBody& body, const PlannedRun& planned, const Study& study,
                   const motion::Sample& early) {
  constexpr double enough = 2e-3;
  std::array<double, 1> end{study.early};
  const auto integrate = [&] {
    return motion::integrate(body, *planned.method, planned.control, end);
  };
  motion::Trajectory path = integrate();
  planned.result->early_error = (path.samples[0].X - early.X).norm();
  for (;;) {
    const std::clock_t start = std::clock();
    double seconds = 0;
    int calls = 0;
    do {
      path = integrate();
      ++calls;
      seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    } while (seconds < enough && end[0] == study.duration);
    if (seconds >= enough) return {seconds / calls, path.evaluations};
    end[0] = std::min(4 * end[0], study.duration);
  }
}

/// Carries out the runs, and reports each to the plan. The processor time is measured first, while
/// nothing else runs. `reference` has the samples at the early time and at the end.
void carry_out(const motion::FreeBody& body, const std::vector<PlannedRun>& runs,
               const StudyPlan& plan, const Study& study,
               const std::vector<motion::Sample>& reference) {
  std::vector<Cost> starts(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    StudyRun& run = *runs[i].result;
    run.step = runs[i].control.step;
    if (runs[i].method->adaptive()) run.tolerance = runs[i].control.tolerance;
    record_failure(run, [&] { starts[i] = measure_start(body, runs[i], study, reference[0]); });
  }
  std::mutex mutex;
  std::size_t done = 0;
  for_each_part(runs.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      StudyRun& run = *runs[i].result;
      record_failure(run, [&] {
        measure_steps(body, runs[i], study, reference[1]);
        run.cpu_seconds = starts[i].cpu_seconds * static_cast<double>(run.evaluations) /
                          static_cast<double>(starts[i].evaluations);
      });
      const std::lock_guard lock(mutex);
      ++done;
      if (plan.progress) plan.progress(done, runs.size());
    }
  });
}

/// Returns the order, from the errors above round-off and within the asymptotic range.
std::optional<double> order_of(const std::vector<StudyRun>& runs) {
  constexpr double round_off = 1e-12, asymptotic = 0.1;
  std::vector<PowerLawPoint> points;
  for (const StudyRun& run : runs) {
    if (run.failure.empty() && run.early_error > round_off && run.early_error < asymptotic) {
      points.push_back({run.step, run.early_error});
    }
  }
  return fitted_exponent(points);
}

std::optional<double> estimate_exponent_of(const std::vector<StudyRun>& runs) {
  std::vector<PowerLawPoint> points;
  for (const StudyRun& run : runs) {
    if (run.failure.empty() && run.estimate && std::isfinite(run.estimate->median_ratio)) {
      points.push_back({run.step, run.estimate->median_ratio});
    }
  }
  return fitted_exponent(points);
}

/// Returns the step controls for the method, one per run. The closed form has a single run with the
/// finest steps, which are only used to search for flips.
std::vector<motion::StepControl> controls_for(const motion::Method& method, const StudyPlan& plan) {
  std::vector<motion::StepControl> controls;
  if (method.adaptive()) {
    for (const double t : plan.tolerances) {
      controls.push_back({plan.first_step, t, plan.max_steps, plan.stop});
    }
  } else if (method.exact()) {
    controls.push_back({.step = std::ranges::min(plan.steps)});
  } else {
    for (const double h : plan.steps) {
      controls.push_back({.step = h, .max_steps = plan.max_steps, .stop = plan.stop});
    }
  }
  return controls;
}

}  // namespace

Study run_study(const motion::FreeBody& body, const StudyPlan& plan) {
  constexpr int steepest = 8;  // Steeper slopes have too few points above round-off.
  require_positive("duration", plan.duration);
  if (plan.steps.empty()) throw InvalidArgument("steps", "there must be one at least");
  for (const motion::Method* method : plan.methods) {
    if (method == nullptr) throw InvalidArgument("methods", "one is null");
    if (method->adaptive() && plan.tolerances.empty()) {
      throw InvalidArgument("tolerances", "there must be one at least");
    }
  }
  Study result;
  result.reference = &motion::reference_method(body);
  result.loses_energy = body.energy_loss() > 0;
  result.duration = plan.duration;
  result.early = early_time(plan.duration, body.omega().norm());
  if (result.reference->exact()) result.flips = motion::ExactMotion(body).flips();
  const std::vector<motion::Sample> reference =
      reference_at(body, std::array{result.early, result.duration});
  if (has_flips(result)) result.flip_times = reference_flip_times(body, plan.duration);
  std::vector<std::vector<motion::StepControl>> controls;
  for (const motion::Method* method : plan.methods) {
    controls.push_back(controls_for(*method, plan));
    result.methods.push_back({method, std::vector<StudyRun>(controls.back().size()), {}, {}});
  }
  std::vector<PlannedRun> runs;
  for (std::size_t i = 0; i < controls.size(); ++i) {
    for (std::size_t k = 0; k < controls[i].size(); ++k) {
      runs.push_back({plan.methods[i], controls[i][k], &result.methods[i].runs[k]});
    }
  }
  carry_out(body, runs, plan, result, reference);
  for (MethodStudy& of_method : result.methods) {
    if (of_method.method->order.value_or(steepest + 1) <= steepest) {
      of_method.order = order_of(of_method.runs);
    }
    of_method.estimate_exponent = estimate_exponent_of(of_method.runs);
  }
  return result;
}

}  // namespace twrench::study
