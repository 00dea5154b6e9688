#include <twrench/motion/stability.h>

#include <cmath>

#include "report/sections.h"
#include "report/tables.h"
#include "scene/prediction.h"

namespace twrench::report {
namespace {

std::vector<std::string> row_of(std::string name, const Eigen::Vector3d& values) {
  return {std::move(name), digits(values[0]), digits(values[1]), digits(values[2])};
}

Table inertia_table(const body::MassProperties& body, const Experiment& experiment) {
  Table table{.caption = Phrase("Inertia matrix about the centre of mass, in body axes",
                                "Treghetsmatrisen om massesenteret, i legemets akser")
                             .in(experiment.scene.language),
              .commands = {experiment.commands.inertia},
              .header = {"I, g cm²", "x", "y", "z"},
              .rows = {}};
  for (int i = 0; i < 3; ++i) {
    table.rows.push_back(row_of(std::string(1, "xyz"[i]), body.inertia.row(i).transpose()));
  }
  return table;
}

Table mass_table(const body::MassProperties& body, const Experiment& experiment) {
  const Language language = experiment.scene.language;
  return {.caption = Phrase("Mass and centre of mass", "Masse og massesenter").in(language),
          .commands = {experiment.commands.inertia},
          .header = quantity_header(language),
          .rows = {{Phrase("Mass", "Masse").in(language), digits(body.mass), "g"},
                   {Phrase("Centre of mass", "Massesenter").in(language),
                    triple(body.centre_of_mass), "cm"}}};
}

/// The behaviour of a small tilt.
Phrase name_of_tilt(motion::Stability::Kind kind) {
  switch (kind) {
    case motion::Stability::Kind::stable:
      return {"stable", "stabil"};
    case motion::Stability::Kind::unstable:
      return {"unstable", "ustabil"};
    case motion::Stability::Kind::neutral:
      break;
  }
  return {"neutral", "nøytral"};
}

}  // namespace

std::vector<std::string> quantity_header(Language language) {
  return {Phrase("Quantity", "Størrelse").in(language), Phrase("Value", "Verdi").in(language),
          Phrase("Unit", "Enhet").in(language)};
}

Table axes_table(const Experiment& experiment) {
  const body::MassProperties body = scene::mass_properties(experiment.scene.body);
  const Language language = experiment.scene.language;
  Table table{
      .caption =
          Phrase("Principal moments and axes, and a small tilt of a steady rotation at 1 rad/s",
                 "Hovedtreghetsmomenter og hovedakser, og en liten helling under en jevn "
                 "rotasjon med 1 rad/s")
              .in(language),
      .commands = {experiment.commands.inertia},
      .header = {Phrase("Axis", "Akse").in(language),
                 Phrase("Moment, g cm²", "Treghetsmoment, g cm²").in(language),
                 Phrase("Direction in body axes", "Retning i legemets akser").in(language),
                 Phrase("A small tilt", "En liten helling").in(language),
                 Phrase("Rate, rad/s or 1/s", "Rate, rad/s eller 1/s").in(language),
                 Phrase("Period or doubling time, s", "Periode eller doblingstid, s").in(language)},
      .rows = {}};
  for (const auto i : body::PrincipalAxes::all) {
    const motion::Stability tilt = motion::stability(body.moments, i, 1);
    const bool grows = tilt.kind == motion::Stability::Kind::unstable;
    const bool wobbles = tilt.kind == motion::Stability::Kind::stable;
    table.rows.push_back({scene::axis_name(body.axes, i), digits(body.moments[i]),
                          triple(Eigen::Vector3d(body.axes.col(i))),
                          name_of_tilt(tilt.kind).in(language), digits(tilt.rate),
                          digits(grows     ? tilt.doubling_time()
                                 : wobbles ? tilt.period()
                                           : std::nan(""))});
  }
  return table;
}

Section body_section(const Experiment& experiment) {
  const body::MassProperties body = scene::mass_properties(experiment.scene.body);
  Section section{.heading = Phrase("The body", "Legemet").in(experiment.scene.language),
                  .content = {}};
  if (std::isfinite(body.mass)) section.content.emplace_back(mass_table(body, experiment));
  section.content.emplace_back(inertia_table(body, experiment));
  section.content.emplace_back(axes_table(experiment));
  return section;
}

}  // namespace twrench::report
