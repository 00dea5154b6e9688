#include "picture/look/force_style.h"

#include <array>

namespace twrench::picture {

const std::vector<Force>& forces_in(scene::Frame frame) {
  using enum Force;
  static const std::array<std::vector<Force>, 3> forces{
      std::vector{constraint}, std::vector{centrifugal, euler, constraint},
      std::vector{centrifugal, coriolis, constraint}};
  return forces[static_cast<std::size_t>(frame)];
}

const scene::Phrase& name_of(Force force) {
  static constexpr std::array<scene::Phrase, 4> names{{{"centrifugal", "sentrifugal"},
                                                       {"Coriolis", "Coriolis"},
                                                       {"Euler", "Euler"},
                                                       {"what holds it", "det som holder"}}};
  return names.at(static_cast<std::size_t>(force));
}

Color color_of(Force force, const OverlayColors& colors) {
  // The axes' colours are distinguishable with every type of colour vision, and forces are seldom
  // shown together with the axes.
  if (force == Force::constraint) return colors.dim;
  return colors.axis[static_cast<std::size_t>(force)];
}

Color color_of_sum(const OverlayColors& colors) { return colors.omega; }

Color color_of_further(const OverlayColors& colors) { return colors.axis[0]; }

Color color_of_back(const OverlayColors& colors) { return colors.axis[2]; }

}  // namespace twrench::picture
