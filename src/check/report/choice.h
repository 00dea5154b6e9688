#pragma once

#include "check/conventions/convention.h"
#include "check/reading/recording.h"
#include "check/verdict/problem.h"

namespace twrench::check {

/// Returns the convention of a recording; `given` determines some of its aspects. Throws
/// InvalidArgument if the names of the columns leave other aspects open. The remedy names the only
/// reading that fits the physics, if there is one.
Convention choose_convention(const Recording& recording, const Convention& given,
                             const Problem& problem);

}  // namespace twrench::check
