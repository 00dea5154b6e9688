#pragma once

#include <vector>

#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::recording {

/// Narrows conventions that differ in the column of the time, and adds the unit that follows from
/// its numbers if neither its name nor the user states one.
///
/// Of several times, those that do not increase are left out. The time of a sample is preferred to
/// that of its message; of times with the same intervals the first by its name is taken.
///
/// Whole numbers get a unit if they cannot be seconds: if they would be beyond the year 2100 or,
/// under names other than `t` and `time`, more than 100 s apart. A unit is possible if the rows are
/// then between 2 s and 50 us apart, and the clock does not run beyond 2100; a clock that then
/// counts from 1970 decides. If several units remain possible, a convention for each is returned.
/// Throws what Recording::first_rows throws.
std::vector<Convention> with_times(const Recording& recording, std::vector<Convention> open);

}  // namespace twrench::recording
