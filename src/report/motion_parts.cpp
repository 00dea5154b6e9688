#include "report/motion_parts.h"

#include <fmt/format.h>
#include <twrench/motion/diagnostics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/energy_contours.h"
#include "motion/phase.h"
#include "plot/plots.h"
#include "report/sections.h"
#include "report/tables.h"

namespace twrench::report {
namespace {

constexpr std::size_t most_flips = 12;  // in a table

Phrase name_of(motion::ExactMotion::Kind kind) {
  switch (kind) {
    case motion::ExactMotion::Kind::steady:
      return {"steady: ω is constant", "jevn: ω er konstant"};
    case motion::ExactMotion::Kind::about_least:
      return {"L circles the axis of least moment", "L kretser om aksen med minst treghetsmoment"};
    case motion::ExactMotion::Kind::about_greatest:
      return {"L circles the axis of greatest moment",
              "L kretser om aksen med størst treghetsmoment"};
    case motion::ExactMotion::Kind::separatrix:
      break;
  }
  return {"on the separatrix: L tends to the intermediate axis",
          "på separatrisen: L går mot den midterste aksen"};
}

void add_flip_rows(Table& table, const motion::ExactMotion::Flips& flips, Language language) {
  table.rows.insert(
      table.rows.end(),
      {{"λ", digits(flips.rate), "1/s"},
       {"1 − m", digits(flips.mc), ""},
       {(flips.turns_over()
             ? Phrase("Time between flips, 2K(m)/λ", "Tid mellom vendinger, 2K(m)/λ")
             : Phrase("Time of half a wobble, 2K(m)/λ", "Tid for en halv slingring, 2K(m)/λ"))
            .in(language),
        digits(flips.interval), "s"},
       {Phrase("Its limit near the separatrix, ln(16/(1 − m))/λ",
               "Grenseverdien nær separatrisen, ln(16/(1 − m))/λ")
            .in(language),
        digits(flips.asymptotic_interval), "s"},
       {Phrase("First sign change of ω₂, t₁", "Første fortegnsskifte for ω₂, t₁").in(language),
        digits(flips.first), "s"},
       {Phrase("Swing of the intermediate axis", "Utslaget til den midterste aksen").in(language),
        digits(flips.swing * 180 / std::numbers::pi), Phrase("degrees", "grader").in(language)}});
}

void add_phase_rows(Table& table, const motion::FreeBody& body, Language language) {
  const auto phase = motion::phase_of(body);
  if (!phase) return;
  table.rows.insert(
      table.rows.end(),
      {{Phrase("Period P in which L returns in the body", "Periode P for L, sett fra legemet")
            .in(language),
        digits(phase->period), "s"},
       {Phrase("Rotation about L in that time", "Rotasjon om L i den tiden").in(language),
        digits(phase->total), "rad"},
       {Phrase("Its dynamic part", "Den dynamiske delen").in(language) +
            (body.is_rigid() ? ", 2TP/|L|" : ""),
        digits(phase->dynamic), "rad"},
       {Phrase("Its geometric part", "Den geometriske delen").in(language),
        digits(phase->geometric()), "rad"}});
}

/// The number of steady rotations with this L, and the least energy.
void add_steady_rows(Table& table, const motion::FreeBody& body, Language language) {
  if (body.momentum().isZero()) return;
  const motion::EnergyContours contours(body);
  const double unit = std::pow(body.momentum().stableNorm(), 2) / body.principal().moments[0];
  const auto& equilibria = contours.equilibria();
  table.rows.insert(
      table.rows.end(),
      {{Phrase("Steady rotations with this L", "Jevne rotasjoner med denne L").in(language),
        fmt::to_string(equilibria.size()), ""},
       {Phrase("Least energy with this L", "Minste energi med denne L").in(language),
        digits(unit * contours.energy(equilibria.front().mu)), "g cm²/s²"}});
}

void add_interior_rows(Table& table, const Solution& solution) {
  const motion::FreeBody& body = solution.body;
  const Language language = solution.scene().language;
  const motion::Interior& interior = body.interior();
  if (!interior.wheel.isZero()) {
    table.rows.push_back({Phrase("Wheel h, body axes", "Svinghjul h, legemets akser").in(language),
                          triple(interior.wheel), "g cm²/s"});
  }
  if (body.energy_loss() > 0) {
    const motion::Sample& end = solution.reference.back();
    const double energy = body.energy(end.X.transpose() * body.momentum());
    table.rows.insert(
        table.rows.end(),
        {{Phrase("Time of the energy loss τ", "Tidskonstant for energitapet τ").in(language),
          digits(interior.energy_loss_time), "s"},
         {Phrase("Coefficient a", "Koeffisient a").in(language), digits(body.energy_loss()),
          "s/(g cm²)"},
         {Phrase("Energy T at the end", "Energi T ved slutten").in(language), digits(energy),
          "g cm²/s²"}});
  }
  add_steady_rows(table, body, language);
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
                      method.adaptive() ? Phrase("tolerance {}", "toleranse {}")
                                              .in(solution.scene().language, control.tolerance)
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
  const Language language = solution.scene().language;
  Table table{
      .caption = Phrase("The motion: its constants", "Konstantene for bevegelsen").in(language),
      .commands = {solution.experiment->commands.start, solution.experiment->commands.constants},
      .header = quantity_header(language),
      .rows = {{Phrase("ω at t = 0, body axes", "ω ved t = 0, legemets akser").in(language),
                triple(body.omega()), "rad/s"},
               {Phrase("|ω| at t = 0", "|ω| ved t = 0").in(language), digits(body.omega().norm()),
                "rad/s"},
               {(body.is_rigid() ? "L = Iω(0)" : "L") +
                    Phrase(", space axes", ", rommets akser").in(language),
                triple(body.momentum()), "g cm²/s"},
               {Phrase("Energy T", "Energi T").in(language),
                digits(motion::energy(body.inertia(), body.omega())), "g cm²/s²"},
               {Phrase("Duration", "Varighet").in(language),
                digits(solution.scene().motion.duration), "s"}}};
  if (solution.exact) {
    table.rows.push_back(
        {Phrase("Kind", "Type").in(language), name_of(solution.exact->kind()).in(language), ""});
  }
  if (!body.is_rigid()) add_interior_rows(table, solution);
  if (const auto flips = solution.flips()) add_flip_rows(table, *flips, language);
  add_phase_rows(table, body, language);
  return table;
}

Table flips_table(const Solution& solution, const std::vector<NumericalSolution>& solutions) {
  const std::vector<double>& predicted = solution.own.flip_times;
  const Language language = solution.scene().language;
  Table table{
      .caption =
          Phrase("Flips: {} predicted", "Vendinger: {} forutsagt").in(language, predicted.size()),
      .commands = commands_of(solutions),
      .header = {Phrase("Flip", "Vending").in(language),
                 Phrase("Predicted, s", "Forutsagt, s").in(language)},
      .rows = {}};
  std::size_t rows = predicted.size();
  for (const NumericalSolution& s : solutions) {
    table.caption += Phrase(", {} seen in the solution of {}", ", {} funnet i løsningen med {}")
                         .in(language, s.run->flips.size(), s.name);
    table.header.insert(table.header.end(),
                        {s.name, Phrase("Difference, s", "Avvik, s").in(language)});
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
  const Language language = solution.scene().language;
  Table table{
      .caption = Phrase("Drift in {} s: the largest of all steps, and the error of X at the "
                        "end",
                        "Drift i løpet av {} s: den største av alle steg, og feilen i X ved "
                        "slutten")
                     .in(language, digits(solution.own.duration)),
      .commands = commands_of(solutions),
      .header = {quantity_header(language).front()},
      .rows = {{Phrase("Steps", "Antall steg").in(language)},
               {(solution.own.loses_energy ? Phrase("Energy error", "Energifeil")
                                           : Phrase("Energy drift", "Energidrift"))
                    .in(language)},
               {"‖XᵀX − Id‖"},
               {Phrase("Momentum error", "Feil i dreieimpulsen").in(language)},
               {Phrase("Error of X at the end", "Feil i X ved slutten").in(language)}}};
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
          .caption = (curve.flips.empty()
                          ? Phrase("{}: the nine components of X against time",
                                   "{}: de ni komponentene av X mot tiden")
                          : Phrase("{}: the nine components of X against time, with the flips",
                                   "{}: de ni komponentene av X mot tiden, med vendingene"))
                         .in(scene.language, scene.shown_title()),
          .command = std::move(command),
          .plot = plot::nine_panels({{curve}}, scene.language)};
}

}  // namespace twrench::report
