#include <fmt/format.h>
#include <twrench/motion/stability.h>

#include <cmath>

#include "base/enumeration.h"
#include "report/numbers.h"
#include "report/sections.h"
#include "scene/prediction.h"

namespace twrench::report {
namespace {

std::vector<std::string> row_of(std::string name, const Eigen::Vector3d& values) {
  return {std::move(name), digits(values[0]), digits(values[1]), digits(values[2])};
}

Table inertia_table(const body::MassProperties& body, const std::string& command) {
  Table table{.caption = "Inertia matrix about the centre of mass, in body axes",
              .commands = {command},
              .header = {"I, g cm²", "x", "y", "z"},
              .rows = {}};
  for (int i = 0; i < 3; ++i) {
    table.rows.push_back(row_of(std::string(1, "xyz"[i]), body.inertia.row(i).transpose()));
  }
  return table;
}

Table mass_table(const body::MassProperties& body, const std::string& command) {
  return {.caption = "Mass and centre of mass",
          .commands = {command},
          .header = {"Quantity", "Value", "Unit"},
          .rows = {{"Mass", digits(body.mass), "g"},
                   {"Centre of mass", triple(body.centre_of_mass), "cm"}}};
}

}  // namespace

Table axes_table(const Experiment& experiment) {
  const body::MassProperties body = scene::mass_properties(experiment.scene.body);
  Table table{
      .caption = "Principal moments and axes, and a small tilt of a steady rotation at 1 rad/s",
      .commands = {experiment.commands.inertia},
      .header = {"Axis", "Moment, g cm²", "Direction in body axes", "A small tilt",
                 "Rate, rad/s or 1/s", "Period or doubling time, s"},
      .rows = {}};
  for (const auto i : body::PrincipalAxes::all) {
    const motion::Stability tilt = motion::stability(body.moments, i, 1);
    const bool grows = tilt.kind == motion::Stability::Kind::unstable;
    const bool wobbles = tilt.kind == motion::Stability::Kind::stable;
    table.rows.push_back({scene::axis_name(body.axes, i), digits(body.moments[i]),
                          triple(Eigen::Vector3d(body.axes.col(i))),
                          std::string(enumerator_name(tilt.kind)), digits(tilt.rate),
                          digits(grows     ? tilt.doubling_time()
                                 : wobbles ? tilt.period()
                                           : std::nan(""))});
  }
  return table;
}

Section body_section(const Experiment& experiment) {
  const body::MassProperties body = scene::mass_properties(experiment.scene.body);
  const std::string& command = experiment.commands.inertia;
  Section section{.heading = "The body", .content = {}};
  if (std::isfinite(body.mass)) section.content.emplace_back(mass_table(body, command));
  section.content.emplace_back(inertia_table(body, command));
  section.content.emplace_back(axes_table(experiment));
  return section;
}

}  // namespace twrench::report
