#pragma once

#include <string>

#include "scene/scene.h"

namespace twrench::app {

/// Returns the effect of a small tilt of the body, the ratio of its moments, and how often it
/// flips.
std::string motion_summary(const scene::Scene& scene);

}  // namespace twrench::app
