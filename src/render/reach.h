#pragma once

#include <span>

#include "body/shape.h"

namespace twrench {

/// Returns a bounding radius in cm of the parts about the origin: the smallest one, except for an
/// ellipsoid that is neither a sphere nor at the origin, for which it may be larger.
double reach(std::span<const Part> parts);

}  // namespace twrench
