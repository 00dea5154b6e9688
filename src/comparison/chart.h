#pragma once

#include <string>

#include "comparison/comparison.h"

namespace twrench::comparison {

/// Returns an HTML figure that shows how much each frame of a film differs, on a logarithmic scale.
/// A bar for several frames shows the worst of them.
std::string difference_chart(const Comparison& comparison);

}  // namespace twrench::comparison
