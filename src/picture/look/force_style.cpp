#include "picture/look/force_style.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace twrench::picture {

const std::vector<Force>& forces_in(scene::Frame frame) {
  using enum Force;
  static const std::array<std::vector<Force>, 3> forces{
      std::vector{constraint}, std::vector{centrifugal, euler, constraint},
      std::vector{centrifugal, coriolis, constraint}};
  return forces[static_cast<std::size_t>(frame)];
}

std::vector<Force> shown_forces(const scene::Overlay& overlay, const std::vector<Force>& forces) {
  std::vector<Force> shown;
  std::ranges::copy_if(forces, std::back_inserter(shown),
                       [&](Force force) { return overlay.forces.contains(force); });
  return shown;
}

const std::vector<Force>& forces_on_tip() {
  static const std::vector forces{Force::centrifugal, Force::coriolis, Force::sum};
  return forces;
}

const scene::Phrase& name_of(Force force) {
  static constexpr std::array<scene::Phrase, 5> names{{{"centrifugal", "sentrifugal"},
                                                       {"Coriolis", "Coriolis"},
                                                       {"Euler", "Euler"},
                                                       {"what holds it", "det som holder"},
                                                       {"sum", "sum"}}};
  return names.at(static_cast<std::size_t>(force));
}

Color color_of(Force force, const OverlayColors& colors) {
  switch (force) {
    case Force::centrifugal:
    case Force::coriolis:
    case Force::euler:
      return colors.force.at(static_cast<std::size_t>(force));
    case Force::constraint:
      return colors.dim;
    case Force::sum:
      return colors.text;
  }
  return {};
}

// The centrifugal force tilts a body further; the Euler force is not shown together with torques.
Color color_of_further(const OverlayColors& colors) { return colors.force[0]; }

Color color_of_back(const OverlayColors& colors) { return colors.force[2]; }

}  // namespace twrench::picture
