#pragma once

#include <twrench/body/shape.h>

#include <vector>

#include "picture/body/occluders.h"

namespace twrench::picture {

/// Returns capsules that together approximate a part of any shape: its surface in pieces of about
/// the same size (Lloyd's k-means), and about each piece a capsule along that's longest axis, or
/// below a piece that is flat.
std::vector<Capsule> lumps(const body::Part& part);

}  // namespace twrench::picture
