#pragma once

#include <vector>

#include "picture/look/theme.h"
#include "scene/phrase.h"

namespace twrench::picture {

using scene::Force;

/// Returns the kinds of forces on a part in a frame, in the order in which they are listed. In
/// space there is only the constraint force, which holds the parts. In the body frame, where the
/// parts are at rest, there is no Coriolis force. In a frame that turns steadily there is no Euler
/// force.
const std::vector<Force>& forces_in(scene::Frame frame);

/// Returns those of `forces` that the scene shows.
std::vector<Force> shown_forces(const scene::Overlay& overlay, const std::vector<Force>& forces);

/// Returns the forces on the tip of an axis.
const std::vector<Force>& forces_on_tip();

/// Returns the name of the force for a legend.
const scene::Phrase& name_of(Force force);

/// Returns the colour of the force's arrows and of its name.
Color color_of(Force force, const OverlayColors& colors);

/// Returns the colour of the torques that tilt the body further, and of those that tilt it back.
Color color_of_further(const OverlayColors& colors);
Color color_of_back(const OverlayColors& colors);

}  // namespace twrench::picture
