#pragma once

#include <span>
#include <vector>

#include "body/shape.h"

namespace twrench {

/// The parts as they are drawn, which is geometry of the picture only: the masses stay those of
/// the parts given.
///
/// Where the middle of a cylinder's end face just touches another part, as the T-wrench's leg
/// touches its handle along one line, the cylinder is carried on into that part: up to its axis
/// (a cylinder) or the height of its centre (a box or an ellipsoid), if there its end lies hidden
/// inside. So no gap shows where the parts meet.
std::vector<Part> joined_parts(std::span<const Part> parts);

}  // namespace twrench
