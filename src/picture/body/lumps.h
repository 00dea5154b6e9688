#pragma once

#include <twrench/body/shape.h>

#include <vector>

#include "picture/body/occluders.h"

namespace twrench::picture {

/// Returns capsules that together approximate a part of any shape. The surface is divided into
/// pieces of about the same size (Lloyd's k-means). Each piece gets a capsule along its longest
/// axis, or below the piece if it is flat.
std::vector<Capsule> lumps(const body::Part& part);

}  // namespace twrench::picture
