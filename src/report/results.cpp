#include "report/results.h"

#include <fmt/format.h>
#include <twrench/motion/method.h>

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

namespace {

/// States the source of the numbers; part of every introduction.
Paragraph about_numbers(Language language, Citations& citations) {
  return {Phrase("The motion is also known in closed form {}, which gives the error of every "
                 "method. All numbers were computed when this report was written; below each table "
                 "and figure stand the commands that give the same.",
                 "Bevegelsen er også kjent på lukket form {}, og det gir feilen til hver metode. "
                 "Alle tallene ble regnet ut da rapporten ble skrevet. Under hver tabell og figur "
                 "står kommandoene som gir de samme tallene.")
              .in(language, citations.cite_method(motion::find_method("exact").source))};
}

}  // namespace

Section introduction_to_tasks(Language language, Citations& citations) {
  const std::string effect = citations.cite(ashbaugh);
  Section section{.heading = Phrase("Introduction", "Innledning").in(language), .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase(
          "A rigid body on which no external torque acts turns about its centre of mass, and its "
          "motion can be surprising: a T-shaped wrench that spins about its intermediate axis "
          "turns over again and again, although nothing pushes it {}. This report solves the tasks "
          "of {}: it computes how such a body turns, by methods that keep its attitude a rotation, "
          "tests the methods, and explains what the solutions show.",
          "Et stivt legeme som ikke er utsatt for ytre kraftmomenter, roterer om massesenteret "
          "sitt, og bevegelsen kan være overraskende: En T-nøkkel som spinner om den midterste "
          "aksen, snur om og om igjen, enda ingenting dytter på den {}. Denne rapporten løser "
          "oppgavene i {}: Den regner ut hvordan et slikt legeme roterer, med metoder der "
          "stillingen forblir en rotasjon, tester metodene og forklarer hva løsningene viser.")
          .in(language, effect, citations.specification())});
  section.content.emplace_back(Paragraph{
      Phrase(
          "Task 1 provides the functions: the exponential, the energy, and the inertia of the "
          "T-wrench. Task 2 solves the motion of a sphere exactly, and task 3 tests the "
          "Lie-Euler method with it. Task 4 is about the Runge-Kutta methods RK4 and RKF45. "
          "Task 5 computes the motion of the T-wrench from three initial angular velocities, "
          "and task 6 draws the nine components of its attitude and interprets them. Then all "
          "methods are compared, and the results discussed.",
          "Oppgave 1 lager funksjonene som trengs: eksponentialfunksjonen, energien og "
          "treghetsmomentet til T-nøkkelen. Oppgave 2 løser bevegelsen til en kule eksakt, og "
          "oppgave 3 bruker løsningen til å teste Lie-Euler-metoden. Oppgave 4 handler om "
          "Runge-Kutta-metodene RK4 og RKF45. Oppgave 5 regner ut bevegelsen til T-nøkkelen for "
          "tre vinkelhastigheter ved start, og oppgave 6 tegner de ni komponentene av stillingen "
          "og tolker dem. Til slutt sammenliknes alle metodene, og resultatene diskuteres.")
          .in(language)});
  section.content.emplace_back(about_numbers(language, citations));
  return section;
}

Section introduction_to_motions(Language language, Citations& citations, bool has_interior) {
  Section section{.heading = Phrase("Introduction", "Innledning").in(language), .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase(
          "This report is about the rotation of a rigid body about its centre of mass when no "
          "external torque acts on it. It contains the equations of {}, the body, its motion, and "
          "a comparison of methods that compute the motion.",
          "Denne rapporten handler om hvordan et stivt legeme roterer om massesenteret sitt når "
          "ingen ytre kraftmomenter virker på det. Den inneholder likningene fra {}, legemet, "
          "bevegelsen og en sammenlikning av metoder som regner den ut.")
          .in(language, citations.specification())});
  section.content.emplace_back(about_numbers(language, citations));
  if (has_interior) {
    section.content.emplace_back(Paragraph{
        Phrase("If a body contains a wheel or loses energy, its motion has no closed form. There "
               "the errors are differences from the method taylor with the tolerance {}.",
               "Hvis legemet inneholder et svinghjul eller taper energi, har bevegelsen ingen "
               "lukket form. Da er feilene avvik fra metoden taylor med toleransen {}.")
            .in(language, motion::min_tolerance)});
  }
  return section;
}

}  // namespace twrench::report
