#include <fmt/format.h>

#include <cmath>

#include "plot/study_plot.h"
#include "report/numbers.h"
#include "report/sections.h"
#include "report/study_tables.h"

namespace twrench::report {
namespace {

Table sources_table(const study::Study& study, Citations& citations) {
  Table table{.caption = "The methods, their sources, and their orders on SO(3)",
              .commands = {"twrench methods"},
              .header = {"Method", "What it is", "Source", "Order", "Measured"},
              .rows = {},
              .text_columns = 3};
  for (const study::MethodStudy& m : study.methods) {
    const motion::Method& method = *m.method;
    table.rows.push_back({std::string(method.name), std::string(method.summary),
                          citations.cite_method(method.source),
                          method.order ? fmt::to_string(*method.order) : "exact",
                          measured_order(study, method.name)});
  }
  return table;
}

std::vector<std::string> row_of_method(const study::MethodStudy& m, const study::Study& study) {
  const std::string name(m.method->name);
  const study::StudyRun* run = middle_run(m);
  if (run == nullptr) return {name, "–", "–", "–", "–", "–", "–", "–", "–"};
  const bool exact = m.method->exact();
  return {name,
          exact ? "–" : fmt::format("{:.4g}", run->step),
          exact ? "–" : brief(run->error),
          brief(run->energy_drift),
          exact ? "–" : brief(run->error / run->energy_drift),
          brief(run->orthogonality_error),
          fmt::format("{}/{}", run->flips.size(), study.flip_times.size()),
          fmt::to_string(run->evaluations),
          fmt::format("{:.3f}", 1e3 * run->cpu_seconds)};
}

Table results_table(const study::Study& study, const Experiment& studied) {
  Table table{.caption = fmt::format("{}: each method at the middle of its ladder of steps or "
                                     "tolerances. Error of X at {} s, largest energy drift, "
                                     "error over drift, flips seen/predicted, and evaluations "
                                     "of ω",
                                     studied.scene.name, digits(study.duration)),
              .commands = {studied.commands.study},
              .header = {"Method", "Step, s", "Error of X", "Drift", "Error/drift", "‖XᵀX − Id‖",
                         "Flips", "Evaluations", "CPU, ms"},
              .rows = {}};
  for (const study::MethodStudy& m : study.methods) table.rows.push_back(row_of_method(m, study));
  return table;
}

/// The methods of the study with a fixed step.
std::vector<std::string> fixed_step_methods(const study::Study& study) {
  std::vector<std::string> names;
  for (const study::MethodStudy& m : study.methods) {
    if (!m.method->exact() && !m.method->adaptive()) names.emplace_back(m.method->name);
  }
  return names;
}

}  // namespace

Section methods_section(const study::Study& study, const Experiment& studied,
                        Citations& citations) {
  Section section{.heading = "All methods", .content = {}};
  section.content.emplace_back(sources_table(study, citations));
  section.content.emplace_back(results_table(study, studied));
  section.content.emplace_back(Figure{
      .name = "methods",
      .caption =
          fmt::format("{}: order (error of X at {:.4g} s), work and precision (error of X at "
                      "{} s), error of X against energy drift, and energy drift against "
                      "time",
                      studied.scene.name, study.early, digits(study.duration)),
      .command = studied.commands.diagrams,
      .plot = plot::study_plot(study)});
  section.content.emplace_back(ladder_table(study, fixed_step_methods(study), studied));
  return section;
}

}  // namespace twrench::report
