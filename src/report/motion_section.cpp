#include "report/motion_parts.h"
#include "report/sections.h"

namespace twrench::report {

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

}  // namespace twrench::report
