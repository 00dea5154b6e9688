#include "report/motion_section.h"

#include <fmt/format.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/error.h>
#include <twrench/motion/exact.h>
#include <twrench/study/study.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plot/attitude_plot.h"
#include "report/numbers.h"

namespace twrench::report {
namespace {

constexpr std::size_t most_flips = 12;  // in a table

const char* name_of(motion::ExactMotion::Kind kind) {
  switch (kind) {
    case motion::ExactMotion::Kind::steady:
      return "steady: ω is constant";
    case motion::ExactMotion::Kind::about_least:
      return "L circles the axis of least moment";
    case motion::ExactMotion::Kind::about_greatest:
      return "L circles the axis of greatest moment";
    case motion::ExactMotion::Kind::separatrix:
      break;
  }
  return "on the separatrix: L tends to the intermediate axis";
}

Table constants_table(const Experiment& experiment, const motion::FreeBody& body,
                      const motion::ExactMotion& exact) {
  Table table{
      .caption = "The motion",
      .command = experiment.commands.constants,
      .header = {"Quantity", "Value", "Unit"},
      .rows = {{"ω at t = 0, body axes", triple(body.omega()), "rad/s"},
               {"L, space axes", triple(body.momentum()), "g cm²/s"},
               {"Kinetic energy", digits(motion::energy(body.inertia(), body.omega())), "g cm²/s²"},
               {"Kind", name_of(exact.kind()), ""},
               {"Duration", digits(experiment.scene.motion.duration), "s"}}};
  if (const auto flips = exact.flips()) {
    table.rows.push_back(
        {flips->turns_over() ? "Time between flips, 2K/|λ|" : "Time of half a wobble, 2K/|λ|",
         digits(flips->interval), "s"});
    table.rows.push_back(
        {"Its approximation near the separatrix", digits(flips->asymptotic_interval), "s"});
    table.rows.push_back({"Swing of the intermediate axis",
                          digits(flips->swing * 180 / std::numbers::pi), "degrees"});
  }
  return table;
}

/// Enough times for smooth curves, but no more than a plot can show.
std::vector<double> plot_times(const scene::Motion& motion) {
  constexpr double a_turn = 60.0, fewest = 600.0, most = 4000.0;
  const double turns = motion.duration * motion.omega.norm() / (2 * std::numbers::pi);
  const double count = std::clamp(std::ceil(a_turn * turns), fewest, most);
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(count); ++i) times.push_back(motion.duration * i / count);
  return times;
}

Figure components_figure(const Experiment& experiment, const motion::ExactMotion& exact) {
  const scene::Scene& scene = experiment.scene;
  plot::AttitudeCurve curve{.title = scene.title.empty() ? scene.name : scene.title,
                            .samples = exact.at(plot_times(scene.motion)),
                            .flips = {}};
  const auto flips = exact.flips();
  if (flips && flips->turns_over() && scene.motion.duration / flips->interval < 100) {
    curve.flips = exact.flip_times(scene.motion.duration);
  }
  return {.name = "components-" + scene.name,
          .caption = "The nine components of X against time" +
                     std::string(curve.flips.empty() ? "" : ", with the flips"),
          .command = experiment.commands.components,
          .plot = plot::nine_panels({{curve}})};
}

/// The scene's own method on it.
study::Study study_of(const Experiment& experiment, const motion::FreeBody& body) {
  const scene::Motion& motion = experiment.scene.motion;
  study::StudyPlan plan;
  plan.methods = {&motion::find_method(motion.method)};
  plan.steps = {motion.control.step};
  plan.tolerances = {motion.control.tolerance};
  plan.first_step = motion.control.step;
  plan.duration = motion.duration;
  plan.max_steps = 1'000'000;
  return study::run_study(body, plan);
}

Table flips_table(const study::Study& study, const study::StudyRun& run,
                  const Experiment& experiment) {
  const std::string method(study.methods.front().method->name);
  Table table{.caption = fmt::format("Flips: {} predicted, {} seen in the solution of {}",
                                     study.flip_times.size(), run.flips.size(), method),
              .command = experiment.commands.own_method,
              .header = {"Flip", "Predicted, s", "Seen, s", "Difference, s"},
              .rows = {}};
  const std::size_t rows = std::max(study.flip_times.size(), run.flips.size());
  for (std::size_t i = 0; i < std::min(rows, most_flips); ++i) {
    const double predicted = i < study.flip_times.size() ? study.flip_times[i] : std::nan("");
    const double seen = i < run.flips.size() ? run.flips[i] : std::nan("");
    table.rows.push_back(
        {fmt::to_string(i + 1), digits(predicted), digits(seen), brief(seen - predicted)});
  }
  return table;
}

Table drift_table(const study::Study& study, const study::StudyRun& run,
                  const Experiment& experiment) {
  const std::string method(study.methods.front().method->name);
  const scene::Motion& motion = experiment.scene.motion;
  const bool adaptive = study.methods.front().method->adaptive();
  return {.caption = fmt::format(
              "How far {} drifts in {} s: the largest value of all steps, and the error at the end",
              method, digits(study.duration)),
          .command = experiment.commands.own_method,
          .header = {"Quantity", "Value"},
          .rows = {{adaptive ? "Tolerance" : "Step, s",
                    digits(adaptive ? motion.control.tolerance : motion.control.step)},
                   {"Steps", fmt::to_string(run.steps)},
                   {"Energy drift", brief(run.energy_drift)},
                   {"Orthogonality error", brief(run.orthogonality_error)},
                   {"Momentum error", brief(run.momentum_error)},
                   {"Error of X at the end", brief(run.error)}}};
}

}  // namespace

Section motion_section(const Experiment& experiment) {
  const scene::Scene& scene = experiment.scene;
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const motion::ExactMotion exact(body);
  Section section{.heading = scene.title.empty() ? scene.name : scene.title, .content = {}};
  section.content.emplace_back(constants_table(experiment, body, exact));
  section.content.emplace_back(components_figure(experiment, exact));
  const study::Study study = study_of(experiment, body);
  const study::StudyRun& run = study.methods.front().runs.front();
  if (!run.failure.empty()) {
    throw motion::MotionError("report " + scene.name, run.failure,
                              motion::MotionError::Reason::step_too_long);
  }
  // Else it wobbles about a stable axis, and turns nothing over.
  if (study.flips && study.flips->turns_over()) {
    section.content.emplace_back(flips_table(study, run, experiment));
  }
  section.content.emplace_back(drift_table(study, run, experiment));
  return section;
}

}  // namespace twrench::report
