#pragma once

#include <string>
#include <vector>

#include "picture/look/theme.h"

namespace twrench::picture {

/// A kind of force on a part of the body, as an observer in a frame of reference accounts for its
/// motion.
enum class Force { centrifugal, coriolis, euler, constraint };

/// Returns the kinds of forces that there are in a frame, in the order in which they are listed. In
/// space there is only what holds the parts; in the body, where they rest, no Coriolis force; and
/// in a frame that turns steadily no Euler force.
const std::vector<Force>& forces_in(scene::Frame frame);

/// Returns the name for a legend.
std::string name_of(Force force);

/// Returns the colour of its arrows and of its name.
Color color_of(Force force, const OverlayColors& colors);

}  // namespace twrench::picture
