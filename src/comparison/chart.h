#pragma once

#include <string>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// Returns a figure of HTML that shows how much each frame of a film differs, on a logarithmic
/// scale: the worst of as many frames as share a bar.
std::string difference_chart(const Comparison& comparison);

}  // namespace twrench::comparison
