#pragma once

#include <string>

#include "scene/scene.h"

namespace twrench::scene {

/// Returns the effect of a small tilt of the body, the ratio of its moments, and how often it
/// flips; of a body that is not rigid, what moves in it and the ratio of its moments.
std::string motion_summary(const Scene& scene);

}  // namespace twrench::scene
