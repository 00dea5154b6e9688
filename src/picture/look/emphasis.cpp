#include "picture/look/emphasis.h"

#include <cmath>

namespace twrench::picture {
namespace {

int mixed(int from, int to) {
  return static_cast<int>(std::lround(std::lerp(from, to, dimmed_opacity)));
}

}  // namespace

Color dimmed(const Color& color, const OverlayColors& colors) {
  const Color& ground = colors.panel;
  return {mixed(ground.red, color.red), mixed(ground.green, color.green),
          mixed(ground.blue, color.blue)};
}

bool is_dimmed(const scene::Overlay& overlay, scene::Feature feature) {
  return !overlay.stress.empty() && !overlay.stress.contains(feature);
}

double thickness_of(const scene::Overlay& overlay, scene::Feature feature) {
  return overlay.stress.contains(feature) ? 1.5 : 1;
}

OverlayColors emphasised(OverlayColors colors, const scene::Overlay& overlay) {
  const auto dim = [&](scene::Feature feature, Color& color) {
    if (is_dimmed(overlay, feature)) color = dimmed(color, colors);
  };
  // All members, so that a new one is not forgotten. The overlays that draw forces dim them.
  auto& [text, secondary, panel, opacity, axes, momentum, omega, forces, trail, plane, curves] =
      colors;
  for (Color& axis : axes) dim(scene::Feature::axes, axis);
  dim(scene::Feature::momentum, momentum);
  dim(scene::Feature::omega, omega);
  dim(scene::Feature::trail, trail);
  dim(scene::Feature::plane, plane);
  return colors;
}

}  // namespace twrench::picture
