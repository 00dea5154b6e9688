#pragma once

#include <vector>

#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::recording {

/// Adds a convention in degrees for each one whose angles are radians only because nothing states
/// their unit, if the first rows have angles beyond a whole turn in radians. Throws what
/// Recording::first_rows throws.
std::vector<Convention> with_angle_units(const Recording& recording, std::vector<Convention> open);

}  // namespace twrench::recording
