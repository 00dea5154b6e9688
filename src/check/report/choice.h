#pragma once

#include <optional>

#include "check/verdict/problem.h"
#include "recording/conventions/convention.h"
#include "recording/recording.h"

namespace twrench::check {

/// Returns the convention of a recording; `given` determines some of its aspects. Throws
/// InvalidArgument if the names of the columns leave other aspects open. The remedy names the only
/// reading that fits the physics of the body, if it is known and there is one.
recording::Convention choose_convention(const recording::Recording& recording,
                                        const recording::Convention& given,
                                        const std::optional<Problem>& problem);

/// Returns how the rates about the body's axes are read, whatever the attitude is. Throws
/// InvalidArgument if there are none, or if the names leave that open.
recording::Convention choose_rates(const recording::Recording& recording,
                                   const recording::Convention& given);

}  // namespace twrench::check
