#include "report/solution.h"

#include <twrench/motion/error.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/reference_motion.h"
#include "scene/shown_recording.h"
#include "study/ladder.h"
#include "study/reference.h"

namespace twrench::report {
namespace {

constexpr std::int64_t most_study_steps = 1'000'000;
constexpr double most_times_of_curve = 20'000;

/// The plan of a study with the default steps and tolerances.
study::StudyPlan ladder_plan(const scene::Motion& motion) {
  study::StudyPlan plan;
  plan.steps = study::step_ladder(motion.duration, motion.omega.norm());
  plan.tolerances = study::tolerance_ladder();
  plan.first_step = plan.steps.front();
  plan.duration = motion.duration;
  plan.max_steps = most_study_steps;
  plan.stop = motion.control.stop;
  return plan;
}

void require_success(const study::StudyRun& run, const Experiment& experiment) {
  if (!run.failure_reason) return;
  throw motion::MotionError("report " + experiment.scene.name, run.failure, *run.failure_reason);
}

}  // namespace

std::optional<motion::ExactMotion::Flips> Solution::flips() const {
  return exact ? exact->flips() : std::nullopt;
}

Solution solve(const Experiment& experiment) {
  const scene::Motion& motion = experiment.scene.motion;
  study::StudyPlan plan;
  plan.methods = {&motion::find_method(motion.method)};
  plan.steps = {motion.control.step};
  plan.tolerances = {motion.control.tolerance};
  plan.first_step = motion.control.step;
  plan.duration = motion.duration;
  plan.max_steps = most_study_steps;
  plan.stop = motion.control.stop;
  const motion::FreeBody body = scene::free_body(experiment.scene);
  Solution solution{&experiment, body, {}, study::run_study(body, plan), {}};
  if (body.is_rigid()) solution.exact.emplace(body);
  require_success(solution.run(), experiment);
  solution.reference = study::reference_at(body, plot_times(motion));
  return solution;
}

PrintedSolution solve_as_printed(const Experiment& experiment) {
  study::StudyPlan plan = ladder_plan(experiment.scene.motion);
  plan.methods = {&motion::find_method("rk4")};
  PrintedSolution result{solve(experiment), {}, 0};
  result.rk4 = study::run_study(result.solution.body, plan);
  const std::vector<study::StudyRun>& runs = result.rk4.methods.front().runs;
  const auto is_quiet = [](const study::StudyRun& run) {
    return !run.failure_reason && run.energy_drift <= unnoticed_drift;
  };
  const auto found = std::ranges::find_if(runs, is_quiet);
  result.quiet = static_cast<std::size_t>(std::min(found, runs.end() - 1) - runs.begin());
  require_success(result.run(), experiment);
  return result;
}

study::Study study_of_all(const Experiment& experiment) {
  study::StudyPlan plan = ladder_plan(experiment.scene.motion);
  const motion::FreeBody body = scene::free_body(experiment.scene);
  for (const motion::Method& method : motion::methods()) {
    if (!method.exact() || motion::ExactMotion::covers(body)) plan.methods.push_back(&method);
  }
  return study::run_study(body, plan);
}

std::vector<double> plot_times(const scene::Motion& motion, double most) {
  constexpr double a_turn = 60.0, fewest = 600.0;
  const double turns = motion.duration * motion.omega.norm() / (2 * std::numbers::pi);
  const double count = std::clamp(std::ceil(a_turn * turns), fewest, most);
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(count); ++i) times.push_back(motion.duration * i / count);
  return times;
}

namespace {

/// The motion by the scene's own method, with the flips of the exact motion if the body turns over.
plot::AttitudeCurve attitude_curve(const scene::Scene& scene) {
  const motion::FreeBody body = scene::free_body(scene);
  const motion::Method& method = motion::find_method(scene.motion.method);
  plot::AttitudeCurve curve;
  curve.title = scene.shown_title();
  curve.samples = motion::integrate(body, method, scene.motion.control,
                                    plot_times(scene.motion, most_times_of_curve))
                      .samples;
  if (body.energy_loss() > 0) return curve;
  const auto flips = body.is_rigid() ? motion::ExactMotion(body).flips() : std::nullopt;
  if (!body.is_rigid() || (flips && flips->turns_over())) {
    curve.flips = study::reference_flip_times(body, scene.motion.duration);
  }
  return curve;
}

}  // namespace

std::vector<plot::AttitudeCurve> shown_curves(const scene::Scene& scene) {
  const auto& recording = scene.motion.recording;
  if (!recording) return {attitude_curve(scene)};
  const std::vector<double> times = plot_times(scene.motion, most_times_of_curve);
  std::vector<plot::AttitudeCurve> curves{
      {scene.shown_title(), recording->motion.samples_at(times), recording->flip_times}};
  if (!recording->has_body) return curves;
  scene::Scene exact = scene;
  const motion::Method& method = motion::reference_method(scene::free_body(scene));
  exact.motion.method = method.name;
  exact.motion.control = motion::reference_control(scene.motion.control.stop);
  exact.title = method.name;
  curves.push_back(attitude_curve(exact));
  curves.back().is_dashed = true;
  return curves;
}

}  // namespace twrench::report
