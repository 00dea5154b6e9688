#include "report/results.h"

#include <algorithm>

#include "report/body_section.h"
#include "report/equations.h"
#include "report/methods_section.h"
#include "report/motion_section.h"

namespace twrench::report {

std::vector<Section> results(std::span<const Experiment> experiments) {
  std::vector<Section> sections{equations()};
  std::vector<Eigen::Matrix3d> described;
  for (const Experiment& experiment : experiments) {
    const Eigen::Matrix3d inertia = scene::mass_properties(experiment.scene.body).inertia;
    if (std::ranges::find(described, inertia) != described.end()) continue;
    described.push_back(inertia);
    sections.push_back(body_section(experiment));
    if (experiments.size() > 1 && described.size() > 1) {
      sections.back().heading += " of " + experiment.scene.name;
    }
  }
  for (const Experiment& experiment : experiments) sections.push_back(motion_section(experiment));
  sections.push_back(methods_section(experiments.front()));
  sections.push_back(references());
  return sections;
}

}  // namespace twrench::report
