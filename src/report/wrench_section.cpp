#include <fmt/format.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>

#include "report/motion_parts.h"
#include "report/sections.h"
#include "report/tables.h"

namespace twrench::report {
namespace {

/// "(a) The Dzhanibekov effect"
std::string experiment_heading(const PrintedSolution& solution, std::size_t i) {
  return fmt::format("({}) {}: ω(0) = {} rad/s", "abc"[i], solution.solution.scene().shown_title(),
                     triple(solution.solution.body.omega()));
}

/// The errors of rk4 by step in all experiments.
Table rk4_table(std::span<const PrintedSolution> solutions) {
  const Language language = solutions.front().solution.scene().language;
  Table table{.caption = Phrase("rk4: energy drift and error of X after {} s, by step",
                                "rk4: energidrift og feil i X etter {} s, etter steglengde")
                             .in(language, digits(solutions.front().rk4.duration)),
              .commands = {},
              .header = {step_label.in(language)},
              .rows = {}};
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    table.header.push_back(fmt::format("({}) drift", "abc"[i]));
    table.header.push_back(Phrase("({}) error", "({}) feil").in(language, "abc"[i]));
    table.commands.push_back(solutions[i].solution.experiment->commands.study_of({"rk4"}));
  }
  for (const study::StudyRun& run : solutions.front().rk4.methods.front().runs) {
    table.rows.push_back({fmt::format("{:.6g}", run.step)});
  }
  for (const PrintedSolution& solution : solutions) {
    const auto& runs = solution.rk4.methods.front().runs;
    for (std::size_t i = 0; i < std::min(runs.size(), table.rows.size()); ++i) {
      const bool done = runs[i].failure.empty();
      table.rows[i].push_back(done ? brief(runs[i].energy_drift) : "–");
      table.rows[i].push_back(done ? brief(runs[i].error) : "–");
    }
  }
  return table;
}

}  // namespace

Section motion_section(const Solution& solution) {
  Section section{.heading = solution.scene().shown_title(), .content = {}};
  section.content.emplace_back(constants_table(solution));
  section.content.emplace_back(
      components_figure(solution, solution.reference, solution.experiment->commands.components));
  section.content.emplace_back(Paragraph{interpretation(solution)});
  // Otherwise it wobbles about a stable axis and does not turn over.
  const auto flips = solution.flips();
  if (flips ? flips->turns_over() : !solution.own.flip_times.empty()) {
    section.content.emplace_back(flips_table(solution, {own_solution(solution)}));
  }
  section.content.emplace_back(drift_table(solution, {own_solution(solution)}));
  return section;
}

Section wrench_section(std::span<const PrintedSolution> solutions) {
  const Language language = solutions.front().solution.scene().language;
  Section section{.heading = Phrase("Task 5: the T-wrench", "Oppgave 5: T-nøkkelen").in(language),
                  .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase("X(0) = Id, so L = Iω(0). The three experiments turn the T-wrench about each of its "
             "axes, with a small component along another, and |ω(0)| is about 1 rad/s. They are "
             "solved with rk4 as in task 4.",
             "X(0) = Id, altså er L = Iω(0). De tre eksperimentene roterer T-nøkkelen om hver sin "
             "akse, med en liten komponent langs en annen, og |ω(0)| er omtrent 1 rad/s. De løses "
             "med rk4 som i oppgave 4.")
          .in(language)});
  section.content.emplace_back(rk4_table(solutions));
  std::string steps;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const study::StudyRun& run = solutions[i].run();
    steps += (i == 0 ? "" : "; ") +
             Phrase("({}) {} s, with a drift of {} and an error of X of {}",
                    "({}) {} s, med en drift på {} og en feil i X på {}")
                 .in(language, "abc"[i], run.step, brief(run.energy_drift), brief(run.error));
  }
  section.content.emplace_back(Paragraph{
      Phrase("The chosen step is the longest of these with an unnoticeable drift, at most {}, or "
             "else the shortest: {}. The error of the attitude is larger than the drift, because "
             "it also contains the phase of the motion, which the energy does not show.",
             "Det valgte steget er det lengste av disse der energien ikke endrer seg nevneverdig, "
             "høyst {}, ellers det korteste: {}. Feilen i stillingen er større enn driften, fordi "
             "den også inneholder fasen til bevegelsen, som ikke vises i energien.")
          .in(language, unnoticed_drift, steps)});
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const Solution& solution = solutions[i].solution;
    const std::vector<NumericalSolution> numerical{rk4_solution(solutions[i]),
                                                   own_solution(solution)};
    section.content.emplace_back(Subheading{experiment_heading(solutions[i], i)});
    section.content.emplace_back(constants_table(solution));
    // Otherwise it wobbles about a stable axis and does not turn over.
    if (solution.own.flips && solution.own.flips->turns_over()) {
      section.content.emplace_back(flips_table(solution, numerical));
    }
    section.content.emplace_back(drift_table(solution, numerical));
  }
  return section;
}

Section components_section(std::span<const PrintedSolution> solutions) {
  const Language language = solutions.front().solution.scene().language;
  Section section{
      .heading = Phrase("Task 6: the nine components of X", "Oppgave 6: de ni komponentene av X")
                     .in(language),
      .content = {}};
  section.content.emplace_back(Paragraph{
      Phrase("The columns of X are the body axes in space: x with the indices i and j is the "
             "component of the body axis j along the space axis i. At t = 0 the axes coincide. The "
             "curves are the solutions by rk4 of task 5.",
             "Søylene i X er legemets akser i rommet: x med indeksene i og j er komponenten av "
             "legemets akse j langs rommets akse i. Ved t = 0 faller aksene sammen. Kurvene er "
             "løsningene med rk4 fra oppgave 5.")
          .in(language)});
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const Solution& solution = solutions[i].solution;
    const scene::Motion& motion = solution.scene().motion;
    const double step = solutions[i].run().step;
    const motion::Trajectory rk4 = motion::integrate(solution.body, motion::find_method("rk4"),
                                                     {.step = step}, plot_times(motion));
    section.content.emplace_back(Subheading{experiment_heading(solutions[i], i)});
    section.content.emplace_back(components_figure(
        solution, rk4.samples, solution.experiment->commands.components_of("rk4", step)));
    section.content.emplace_back(Paragraph{interpretation(solution)});
  }
  section.content.emplace_back(Paragraph{
      Phrase(
          "The component of the axis about which the body spins tells the motions apart. In (a) "
          "this is the intermediate axis, and the component does not stay near 1; in (b) and "
          "(c) it does. As 3-D animations the motions are drawn by the commands twrench render "
          "dzhanibekov, twrench render stable-y and twrench render stable-z.",
          "Komponenten av aksen som legemet spinner om, skiller bevegelsene fra hverandre. I (a) "
          "er det den midterste aksen, og komponenten holder seg ikke nær 1; i (b) og (c) gjør "
          "den det. Som 3-D-animasjoner tegnes bevegelsene av kommandoene twrench render "
          "dzhanibekov, twrench render stable-y og twrench render stable-z.")
          .in(language)});
  return section;
}

}  // namespace twrench::report
