#pragma once

#include <span>

#include "body/shape.h"

namespace twrench {

/// The radius in cm of the sphere about the origin that holds the parts: the smallest one, but for
/// an ellipsoid that is neither a sphere nor at the origin, for which it may be larger.
double reach(std::span<const Part> parts);

}  // namespace twrench
