#include "scene/link_scene.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "scene/limits.h"

namespace twrench::scene {
namespace {

constexpr double cm_per_m = 100.0, g_per_kg = 1000.0;

/// The parts of a link about its centre of mass, with the mass of the link.
std::vector<body::Part> drawn_parts(const robot::LinkGeometry& geometry,
                                    const robot::LinkMass& body) {
  std::vector<body::Part> parts = geometry.parts();
  double volume = 0.0;
  for (const body::Part& part : parts) volume += body::volume(part.shape);
  for (body::Part& part : parts) {
    part.position -= cm_per_m * body.centre;
    part.density = g_per_kg * body.mass / volume;
  }
  return parts;
}

std::string place_of(const robot::JudgedRobot& judged, std::size_t link) {
  return fmt::format("{}: link '{}'", judged.robot.file.string(), judged.robot.links[link].name);
}

}  // namespace

Body link_body(const robot::JudgedRobot& judged, std::size_t link) {
  const robot::Diagnosis& diagnosis = judged.diagnoses[link];
  const std::string what = place_of(judged, link);
  if (diagnosis.verdict == robot::Verdict::unstated) {
    throw InvalidArgument(what, "the file states no mass properties for it",
                          "choose a link that has an <inertial>");
  }
  if (!(diagnosis.moments[0] > 0.0) || !(diagnosis.body.mass > 0.0)) {
    throw InvalidArgument(what, diagnosis.faults.front().text, "repair the file first");
  }
  return link_body(judged, link, diagnosis.body);
}

Body link_body(const robot::JudgedRobot& judged, std::size_t link, const robot::LinkMass& mass) {
  Body body;
  const Eigen::Matrix3d inertia = g_per_kg * cm_per_m * cm_per_m * mass.inertia;
  body.inertia = limits::check_inertia(place_of(judged, link), (inertia + inertia.transpose()) / 2);
  body.parts = drawn_parts(judged.geometries[link], mass);
  return body;
}

}  // namespace twrench::scene
