#pragma once

#include <string>

#include "comparison/comparison.h"

namespace twrench::app {

/// Returns a figure of HTML that shows how much each frame of a film differs, on a logarithmic
/// scale: the worst of as many frames as share a bar.
std::string compare_chart(const comparison::Comparison& comparison);

}  // namespace twrench::app
