#pragma once

#include <twrench/body/shape.h>

#include <span>
#include <vector>

namespace twrench::picture {

/// Returns the parts as they are drawn, with gaps closed. This affects only the picture: the masses
/// are those of the given parts.
///
/// If the centre of a cylinder's end face just touches another part, as the T-wrench's leg touches
/// its handle along one line, the cylinder is extended into that part, up to its axis (for a
/// cylinder, a cone or a capsule), the middle of its wall (for a tube or a torus) or the height of
/// its centre (for a box or an ellipsoid), provided that its end is then hidden inside. Meshes are
/// left alone.
std::vector<body::Part> close_gaps(std::span<const body::Part> parts);

}  // namespace twrench::picture
