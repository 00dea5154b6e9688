#pragma once

#include "picture/look/theme.h"

namespace twrench::picture {

/// The opacity of a feature if a scene stresses others.
inline constexpr double dimmed_opacity = 0.55;

/// Returns whether the scene stresses other features than this one.
bool is_dimmed(const scene::Overlay& overlay, scene::Feature feature);

/// Returns the factor by which a feature is drawn thicker than usual.
double thickness_of(const scene::Overlay& overlay, scene::Feature feature);

/// Returns the colour of a dimmed feature, mixed with the panel's.
Color dimmed(const Color& color, const OverlayColors& colors);

/// Returns the colours with those of the dimmed features among axes, momentum, omega, trail and
/// plane dimmed.
OverlayColors emphasised(OverlayColors colors, const scene::Overlay& overlay);

}  // namespace twrench::picture
