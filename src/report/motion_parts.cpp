#include "report/motion_parts.h"

#include <fmt/format.h>
#include <twrench/motion/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/energy_contours.h"
#include "motion/phase.h"
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

void add_flip_rows(Table& table, const motion::ExactMotion::Flips& flips) {
  table.rows.insert(
      table.rows.end(),
      {{"λ", digits(flips.rate), "1/s"},
       {"1 − m", digits(flips.mc), ""},
       {flips.turns_over() ? "Time between flips, 2K(m)/λ" : "Time of half a wobble, 2K(m)/λ",
        digits(flips.interval), "s"},
       {"Its limit near the separatrix, ln(16/(1 − m))/λ", digits(flips.asymptotic_interval), "s"},
       {"First sign change of ω₂, t₁", digits(flips.first), "s"},
       {"Swing of the intermediate axis", digits(flips.swing * 180 / std::numbers::pi),
        "degrees"}});
}

void add_phase_rows(Table& table, const motion::FreeBody& body) {
  const auto phase = motion::phase_of(body);
  if (!phase) return;
  table.rows.insert(table.rows.end(),
                    {{"Period P in which L returns in the body", digits(phase->period), "s"},
                     {"Rotation about L in that time", digits(phase->total), "rad"},
                     {body.is_rigid() ? "Its dynamic part, 2TP/|L|" : "Its dynamic part",
                      digits(phase->dynamic), "rad"},
                     {"Its geometric part", digits(phase->geometric()), "rad"}});
}

/// The number of steady rotations with this L, and the least energy.
void add_steady_rows(Table& table, const motion::FreeBody& body) {
  if (body.momentum().isZero()) return;
  const motion::EnergyContours contours(body);
  const double unit = std::pow(body.momentum().stableNorm(), 2) / body.principal().moments[0];
  const auto& equilibria = contours.equilibria();
  table.rows.insert(table.rows.end(),
                    {{"Steady rotations with this L", fmt::to_string(equilibria.size()), ""},
                     {"Least energy with this L",
                      digits(unit * contours.energy(equilibria.front().mu)), "g cm²/s²"}});
}

void add_interior_rows(Table& table, const Solution& solution) {
  const motion::FreeBody& body = solution.body;
  const motion::Interior& interior = body.interior();
  if (!interior.wheel.isZero()) {
    table.rows.push_back({"Wheel h, body axes", triple(interior.wheel), "g cm²/s"});
  }
  if (body.energy_loss() > 0) {
    const motion::Sample& end = solution.reference.back();
    const double energy = body.energy(end.X.transpose() * body.momentum());
    table.rows.insert(table.rows.end(),
                      {{"Time of the energy loss τ", digits(interior.energy_loss_time), "s"},
                       {"Coefficient a", digits(body.energy_loss()), "s/(g cm²)"},
                       {"Energy T at the end", digits(energy), "g cm²/s²"}});
  }
  add_steady_rows(table, body);
}

double flip_at(const std::vector<double>& flips, std::size_t i) {
  return i < flips.size() ? flips[i] : std::nan("");
}

std::vector<std::string> commands_of(const std::vector<NumericalSolution>& solutions) {
  std::vector<std::string> commands;
  for (const NumericalSolution& s : solutions) commands.push_back(s.command);
  return commands;
}

}  // namespace

NumericalSolution own_solution(const Solution& solution) {
  const motion::Method& method = *solution.own.methods.front().method;
  const motion::StepControl& control = solution.scene().motion.control;
  return {fmt::format("{}, {}", method.name,
                      method.adaptive() ? fmt::format("tolerance {}", control.tolerance)
                                        : fmt::format("{} s", control.step)),
          &solution.run(), solution.experiment->commands.own_method};
}

NumericalSolution rk4_solution(const PrintedSolution& solution) {
  const double step = solution.run().step;
  return {fmt::format("rk4, {} s", step), &solution.run(),
          solution.solution.experiment->commands.solution("rk4", step)};
}

Table constants_table(const Solution& solution) {
  const motion::FreeBody& body = solution.body;
  Table table{
      .caption = "The motion: its constants",
      .commands = {solution.experiment->commands.start, solution.experiment->commands.constants},
      .header = {"Quantity", "Value", "Unit"},
      .rows = {{"ω at t = 0, body axes", triple(body.omega()), "rad/s"},
               {"|ω| at t = 0", digits(body.omega().norm()), "rad/s"},
               {body.is_rigid() ? "L = Iω(0), space axes" : "L, space axes",
                triple(body.momentum()), "g cm²/s"},
               {"Energy T", digits(motion::energy(body.inertia(), body.omega())), "g cm²/s²"},
               {"Duration", digits(solution.scene().motion.duration), "s"}}};
  if (solution.exact) table.rows.push_back({"Kind", name_of(solution.exact->kind()), ""});
  if (!body.is_rigid()) add_interior_rows(table, solution);
  if (const auto flips = solution.flips()) add_flip_rows(table, *flips);
  add_phase_rows(table, body);
  return table;
}

Table flips_table(const Solution& solution, const std::vector<NumericalSolution>& solutions) {
  const std::vector<double>& predicted = solution.own.flip_times;
  Table table{.caption = fmt::format("Flips: {} predicted", predicted.size()),
              .commands = commands_of(solutions),
              .header = {"Flip", "Predicted, s"},
              .rows = {}};
  std::size_t rows = predicted.size();
  for (const NumericalSolution& s : solutions) {
    table.caption += fmt::format(", {} seen in the solution of {}", s.run->flips.size(), s.name);
    table.header.insert(table.header.end(), {s.name, "Difference, s"});
    rows = std::max(rows, s.run->flips.size());
  }
  for (std::size_t i = 0; i < std::min(rows, most_flips); ++i) {
    std::vector<std::string> row{fmt::to_string(i + 1), digits(flip_at(predicted, i))};
    for (const NumericalSolution& s : solutions) {
      const double seen = flip_at(s.run->flips, i);
      row.push_back(digits(seen));
      row.push_back(brief(seen - flip_at(predicted, i)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table drift_table(const Solution& solution, const std::vector<NumericalSolution>& solutions) {
  Table table{.caption = fmt::format("Drift in {} s: the largest of all steps, and the error of X "
                                     "at the end",
                                     digits(solution.own.duration)),
              .commands = commands_of(solutions),
              .header = {"Quantity"},
              .rows = {{"Steps"},
                       {solution.own.loses_energy ? "Energy error" : "Energy drift"},
                       {"‖XᵀX − Id‖"},
                       {"Momentum error"},
                       {"Error of X at the end"}}};
  for (const NumericalSolution& s : solutions) {
    table.header.push_back(s.name);
    table.rows[0].push_back(fmt::to_string(s.run->steps));
    table.rows[1].push_back(brief(s.run->energy_drift));
    table.rows[2].push_back(brief(s.run->orthogonality_error));
    table.rows[3].push_back(brief(s.run->momentum_error));
    table.rows[4].push_back(brief(s.run->error));
  }
  return table;
}

Figure components_figure(const Solution& solution, std::vector<motion::Sample> samples,
                         std::string command) {
  const scene::Scene& scene = solution.scene();
  plot::AttitudeCurve curve{
      .title = scene.shown_title(), .samples = std::move(samples), .flips = {}};
  const auto flips = solution.flips();
  constexpr std::size_t most = 100;
  if ((!flips || flips->turns_over()) && solution.own.flip_times.size() < most) {
    curve.flips = solution.own.flip_times;
  }
  return {.name = "components-" + scene.name,
          .caption = scene.shown_title() + ": the nine components of X against time" +
                     std::string(curve.flips.empty() ? "" : ", with the flips"),
          .command = std::move(command),
          .plot = plot::nine_panels({{curve}})};
}

}  // namespace twrench::report
