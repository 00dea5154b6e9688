#pragma once

#include <twrench/body/shape.h>

#include <span>
#include <vector>

#include "picture/body/shadow_balls.h"

namespace twrench::page {

/// Returns balls that cast as much shadow as the parts, as the film's do. As many as a shader has
/// room for: of more, those that are closest to one another are taken together.
std::vector<picture::Ball> fewer_shadow_balls(std::span<const body::Part> parts);

}  // namespace twrench::page
