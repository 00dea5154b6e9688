#pragma once

#include <twrench/body/shape.h>

#include <span>
#include <vector>

#include "picture/body/shadow_balls.h"

namespace twrench::page {

/// Returns balls that cast as much shadow as the parts, as in the film. If there are more than a
/// shader has room for, those closest to one another are merged.
std::vector<picture::Ball> reduced_shadow_balls(std::span<const body::Part> parts);

}  // namespace twrench::page
