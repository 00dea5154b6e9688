#include "report/results.h"

#include <algorithm>

#include "report/sections.h"

namespace twrench::report {
namespace {

/// Returns whether a body has a wheel or loses energy.
bool has_interior(std::span<const Experiment> experiments) {
  return !std::ranges::all_of(experiments,
                              [](const Experiment& e) { return e.scene.motion.is_rigid(); });
}

/// One section for each body, because several scenes may have the same one.
std::vector<Section> body_sections(std::span<const Experiment> experiments) {
  std::vector<Section> sections;
  std::vector<Eigen::Matrix3d> described;
  for (const Experiment& experiment : experiments) {
    const Eigen::Matrix3d inertia = scene::mass_properties(experiment.scene.body).inertia;
    if (std::ranges::find(described, inertia) != described.end()) continue;
    described.push_back(inertia);
    sections.push_back(body_section(experiment));
    if (described.size() > 1) sections.back().heading += " of " + experiment.scene.name;
  }
  return sections;
}

}  // namespace

std::vector<Section> report_on_motions(std::span<const Experiment> experiments) {
  Citations citations;
  const bool interior = has_interior(experiments);
  std::vector<Section> sections{introduction_to_motions(citations, interior),
                                theory_section(citations, interior)};
  for (Section& body : body_sections(experiments)) sections.push_back(std::move(body));
  for (const Experiment& experiment : experiments) {
    sections.push_back(motion_section(solve(experiment)));
  }
  const study::Study study = study_of_all(experiments.front());
  sections.push_back(methods_section(study, experiments.front(), citations));
  sections.push_back(discussion_of_motions(study, citations));
  sections.push_back(citations.references());
  return sections;
}

std::vector<Section> report_on_tasks(std::span<const Experiment> experiments,
                                     const TaskCommands& commands) {
  std::vector<PrintedSolution> solutions;
  for (const Experiment& experiment : experiments) {
    solutions.push_back(solve_as_printed(experiment));
  }
  const Experiment& studied = experiments.front();
  const study::Study study = study_of_all(studied);
  Citations citations;
  std::vector<Section> sections{introduction_to_tasks(citations), theory_section(citations, false)};
  sections.push_back(functions_section(solutions, commands, citations));
  sections.push_back(sphere_section(commands, citations));
  sections.push_back(lie_euler_section(study, studied, commands));
  sections.push_back(runge_kutta_section(study, studied, citations));
  sections.push_back(wrench_section(solutions));
  sections.push_back(components_section(solutions));
  sections.push_back(methods_section(study, studied, citations));
  sections.push_back(discussion_of_tasks(solutions, study, citations));
  sections.push_back(citations.references());
  return sections;
}

}  // namespace twrench::report
