#include "report/methods_section.h"

#include <fmt/format.h>
#include <twrench/study/ladder.h>
#include <twrench/study/study.h>

#include <algorithm>
#include <cmath>

#include "plot/study_plot.h"
#include "report/numbers.h"

namespace twrench::report {
namespace {

study::Study study_of_all(const scene::Scene& scene) {
  study::StudyPlan plan;
  for (const motion::Method& method : motion::methods()) plan.methods.push_back(&method);
  plan.steps = study::step_ladder(scene.motion.duration, scene.motion.omega.norm());
  plan.tolerances = study::tolerance_ladder();
  plan.first_step = plan.steps.front();
  plan.duration = scene.motion.duration;
  plan.max_steps = 1'000'000;
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  return study::run_study(body, plan);
}

/// The run in the middle of a method's ladder, or the nearest finer one that did not fail.
const study::StudyRun* middle_run(const study::MethodStudy& method) {
  for (std::size_t i = method.runs.size() / 2; i < method.runs.size(); ++i) {
    if (method.runs[i].failure.empty()) return &method.runs[i];
  }
  return nullptr;
}

std::vector<std::string> row_of_method(const study::MethodStudy& m, const study::Study& study) {
  const std::string name(m.method->name);
  const std::string order = m.method->order ? fmt::to_string(*m.method->order) : "exact";
  const std::string observed = m.order ? fmt::format("{:.2f}", *m.order) : "–";
  const study::StudyRun* run = middle_run(m);
  if (run == nullptr) return {name, order, observed, "–", "–", "–", "–", "–", "–", "–"};
  return {name,
          order,
          observed,
          m.method->exact() ? "–" : fmt::format("{:.4g}", run->step),
          m.method->exact() ? "–" : brief(run->error),
          brief(run->energy_drift),
          brief(run->orthogonality_error),
          fmt::format("{}/{}", run->flips.size(), study.flip_times.size()),
          fmt::to_string(run->evaluations),
          fmt::format("{:.3f}", 1e3 * run->cpu_seconds)};
}

/// The errors of one method along its ladder.
Table ladder_table(const study::Study& study, const std::string& command) {
  Table table{.caption = fmt::format("Error of X at {:.4g} s by step, s", study.early),
              .command = command,
              .header = {"Step, s"},
              .rows = {}};
  std::vector<const study::MethodStudy*> fixed;
  for (const study::MethodStudy& m : study.methods) {
    if (!m.method->exact() && !m.method->adaptive() &&
        !std::holds_alternative<motion::Taylor>(m.method->scheme)) {
      fixed.push_back(&m);
    }
  }
  for (const auto* m : fixed) table.header.emplace_back(m->method->name);
  for (std::size_t i = 0; i < fixed.front()->runs.size(); ++i) {
    std::vector<std::string> row{fmt::format("{:.6g}", fixed.front()->runs[i].step)};
    for (const auto* m : fixed) {
      const study::StudyRun& run = m->runs[i];
      row.push_back(run.failure.empty() ? brief(run.early_error) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Section methods_section(const Experiment& experiment) {
  const study::Study study = study_of_all(experiment.scene);
  const std::string& command = experiment.commands.methods;
  Table table{.caption = fmt::format("Each method at the middle of its ladder of steps or "
                                     "tolerances, {} s of {}",
                                     digits(study.duration), experiment.scene.name),
              .command = command,
              .header = {"Method", "Order", "Measured", "Step, s", "Error of X", "Energy drift",
                         "|XᵀX − Id|", "Flips", "Evaluations", "CPU, ms"},
              .rows = {}};
  for (const study::MethodStudy& m : study.methods) table.rows.push_back(row_of_method(m, study));
  Section section{.heading = "The methods", .content = {}};
  section.content.emplace_back(std::move(table));
  section.content.emplace_back(Figure{
      .name = "methods",
      .caption = fmt::format("Order (error at {:.4g} s), work and precision (error at {} s), "
                             "and energy drift of the methods",
                             study.early, digits(study.duration)),
      .command = experiment.commands.diagrams,
      .plot = plot::study_plot(study)});
  section.content.emplace_back(ladder_table(study, command));
  return section;
}

Section references() {
  std::vector<std::string> items{
      "H. J. Rivertz, Rotasjon av stive legemer (2020): the specification.",
      "L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed. (1976), section 37.",
      "C. G. J. Jacobi, Sur la rotation d'un corps, J. reine angew. Math. 39 (1849), 293-350.",
      "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed. (2006)."};
  for (const motion::Method& method : motion::methods()) {
    const std::string_view source = method.source.substr(0, method.source.find("; docs/"));
    items.push_back(fmt::format("{}: {}.", method.name, source));
  }
  return {.heading = "References", .content = {List{std::move(items)}}};
}

}  // namespace twrench::report
