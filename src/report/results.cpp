#include "report/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "report/sections.h"
#include "scene/languages.h"

namespace twrench::report {
namespace {

/// Returns whether a body has a wheel or loses energy.
bool has_interior(std::span<const Experiment> experiments) {
  return !std::ranges::all_of(experiments,
                              [](const Experiment& e) { return e.scene.motion.is_rigid(); });
}

/// The experiments in the language of the first.
std::vector<Experiment> in_one_language(std::span<const Experiment> experiments) {
  std::vector<Experiment> all(experiments.begin(), experiments.end());
  for (Experiment& experiment : all) experiment.scene.language = all.front().scene.language;
  return all;
}

/// The experiments of task 5 with titles in the language of the report.
std::vector<Experiment> with_titles(std::span<const Experiment> experiments) {
  static constexpr std::array titles{
      Phrase("The Dzhanibekov effect", "Dzjanibekov-effekten"),
      Phrase("Stable rotation about y", "Stabil rotasjon om y"),
      Phrase("Stable rotation about z", "Stabil rotasjon om z"),
  };
  std::vector<Experiment> all = in_one_language(experiments);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    all.at(i).scene.title = titles.at(i).in(all.at(i).scene.language);
  }
  return all;
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
    if (described.size() > 1) {
      sections.back().heading +=
          Phrase(" of {}", " i {}").in(experiment.scene.language, experiment.scene.name);
    }
  }
  return sections;
}

}  // namespace

std::string title_of(std::span<const Experiment> experiments) {
  if (experiments.size() == 1) return experiments.front().scene.shown_title();
  return Phrase("The motion of a free rigid body", "Bevegelsen til et fritt stivt legeme")
      .in(experiments.front().scene.language);
}

std::string note_on_language(std::span<const Experiment> experiments) {
  const scene::Scene& first = experiments.front().scene;
  if (scene::note_on_language(first).empty()) return {};
  return fmt::format("the report is in English, not in '{}'", first.language_tag);
}

std::vector<Section> report_on_motions(std::span<const Experiment> given) {
  const std::vector<Experiment> experiments = in_one_language(given);
  const Language language = experiments.front().scene.language;
  Citations citations(language);
  const bool interior = has_interior(experiments);
  std::vector<Section> sections{introduction_to_motions(language, citations, interior),
                                theory_section(language, citations, interior)};
  for (Section& body : body_sections(experiments)) sections.push_back(std::move(body));
  for (const Experiment& experiment : experiments) {
    sections.push_back(motion_section(solve(experiment)));
  }
  const study::Study study = study_of_all(experiments.front());
  sections.push_back(methods_section(study, experiments.front(), citations));
  sections.push_back(discussion_of_motions(study, language, citations));
  sections.push_back(citations.references());
  return sections;
}

std::vector<Section> report_on_tasks(std::span<const Experiment> given,
                                     const TaskCommands& commands) {
  const std::vector<Experiment> experiments = with_titles(given);
  const Language language = experiments.front().scene.language;
  std::vector<PrintedSolution> solutions;
  for (const Experiment& experiment : experiments) {
    solutions.push_back(solve_as_printed(experiment));
  }
  const Experiment& studied = experiments.front();
  const study::Study study = study_of_all(studied);
  Citations citations(language);
  std::vector<Section> sections{introduction_to_tasks(language, citations),
                                theory_section(language, citations, false)};
  sections.push_back(functions_section(solutions, commands, citations));
  sections.push_back(sphere_section(commands, language, citations));
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
