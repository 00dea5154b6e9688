#pragma once

#include <span>
#include <vector>

#include "body/shape.h"

namespace twrench {

/// Returns the parts as they are drawn, with gaps closed. This affects only the picture: the masses
/// are those of the given parts.
///
/// If the centre of a cylinder's end face just touches another part, as the T-wrench's leg touches
/// its handle along one line, the cylinder is extended into that part, up to its axis (for a
/// cylinder) or the height of its centre (for a box or an ellipsoid), provided that its end is then
/// hidden inside.
std::vector<Part> joined_parts(std::span<const Part> parts);

}  // namespace twrench
